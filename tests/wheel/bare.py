#!/usr/bin/env python3
"""bare.py FILE.whl: the wheel on bare Debian systems, debootstrap's smallest, with Python, NumPy and an OpenGL.

SUITES (bookworm trixie forky) are those tried: with EGL, then, where the suite has it, with OSMesa and no EGL. Labels
and records are equal on all; pixels are equal up to Mesa 25, and later ones within OTHER_PIXELS. It fails beyond
MAX_PICTURE_S (2) to the first picture, MAX_ARRAYS_S (2) to the arrays, MAX_VERSION_S (0.1) for --version, meant for
two idle cores. Needs root, debootstrap and Debian's archive."""

import json
import os
import pathlib
import shutil
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "bare"))

from system import Bare, Failed, lacking  # noqa: E402

SCENARIOS = HERE.parents[1] / "samples/scenarios"
PACKAGES = "python3 python3-venv python3-numpy libgl1-mesa-dri"
LIMITS = {"first picture": ("MAX_PICTURE_S", 2), "three lines of Python": ("MAX_ARRAYS_S", 2),
          "version": ("MAX_VERSION_S", 0.1)}
# Of Mesa 26 beside Mesa 22: at most this share of pixels differs, by at most so much in a channel.
OTHER_PIXELS = (0.005, 2)
INSTALL = """apt-get update -qq
apt-get install -y -qq --no-install-recommends {packages}
id tester > /dev/null 2>&1 || useradd --create-home tester
"""
WITHOUT_EGL = """apt-get install -y -qq --no-install-recommends libosmesa6
dpkg --purge --force-depends libegl1 libegl-mesa0
! ldconfig -p | grep libEGL
"""
TRY = """set -e
cd /home/tester
export HOME=/home/tester/{name} LC_ALL=C.UTF-8
setpriv --reuid=tester --regid=tester --clear-groups sh -ec '
    umask 022; mkdir {name}; cd {name}; exec python3 /try/try.py /try/*.whl /try/scenarios'
"""
VERSION = "dpkg-query -W -f '${Version}' "


def tried(root, name):
    result = json.loads(root.run(TRY.format(name=name)).splitlines()[-1])
    result["name"] = f"{root.suite}, {name}"
    result["mesa"] = root.run(VERSION + "libgl1-mesa-dri").split("-")[0]
    result["python"] = root.run(VERSION + "python3-minimal").split("-")[0]
    rgb = root.root / f"home/tester/{name}/rgb"
    result["rgb"] = rgb.read_bytes() if rgb.exists() else b""
    print(f"{result['name']}: tried", file=sys.stderr)
    return result


def tried_in(suite, wheel):
    """One result, or two; they are there even if what follows fails."""
    with tempfile.TemporaryDirectory() as folder:
        root = Bare.fetch(suite, f"{folder}/{suite}", f"{folder}/{suite}.log")
        (root.root / "try").mkdir()
        shutil.copy(wheel, root.root / "try")
        shutil.copy(HERE / "try.py", root.root / "try")
        shutil.copytree(SCENARIOS, root.root / "try/scenarios")
        root.run(INSTALL.format(packages=f"{PACKAGES} libegl1"))
        yield tried(root, "egl")
        if root.run("apt-cache policy libosmesa6").strip():
            root.run(WITHOUT_EGL)
            yield tried(root, "osmesa")
        elif suite in ("bookworm", "trixie"):
            raise Failed(f"{suite} offers no libosmesa6: claque was to be tried with OSMesa alone")
        else:
            print(f"{suite} has no libosmesa6, so claque is tried there with EGL alone")


def differing(a, b):
    """The share of pixels that differ, and the largest difference of a channel."""
    if len(a) != len(b) or not a:
        return 1, 255
    worst, pixels = 0, 0
    for at in range(0, len(a), 3):
        if a[at:at + 3] != b[at:at + 3]:
            pixels += 1
            worst = max(worst, *(abs(x - y) for x, y in zip(a[at:at + 3], b[at:at + 3])))
    return 3 * pixels / len(a), worst


def faults_of(results):
    first = min(results, key=lambda result: int(result["mesa"].split(".")[0]))
    for result in results:
        yield from (f"{result['name']}: {fault}" for fault in result["faults"])
        later = int(result["mesa"].split(".")[0]) > 25
        for name in sorted(first["hashes"].keys() | result["hashes"].keys()):
            if result["hashes"].get(name) != first["hashes"].get(name) and not (later and name.startswith("pixels")):
                yield f"{result['name']}: {name} differ from those of {first['name']}"
        share, worst = differing(first["rgb"], result["rgb"])
        print(f"{result['name']}: {share:.2%} of the odeon's pixels differ from {first['name']}, by at most {worst}")
        if share > OTHER_PIXELS[0] or worst > OTHER_PIXELS[1]:
            yield f"{result['name']}: more pixels differ than Mesa {result['mesa']} is known for"
        for name, (variable, limit) in LIMITS.items():
            limit = float(os.environ.get(variable, limit))
            if result["seconds"].get(name, [0])[0] > limit:
                yield f"{result['name']}: {name} took {result['seconds'][name][0]:.2f} s, more than {limit:g}"


def table(results):
    """Seconds by the clock, and in brackets those of processors."""
    rows = [[""] + [result["name"] for result in results]]
    rows += [[kind] + [result[kind] for result in results] for kind in ("mesa", "python")]
    for name in dict.fromkeys(name for result in results for name in result["seconds"]):
        times = [result["seconds"].get(name) for result in results]
        rows.append([name] + [f"{one[0]:.2f} ({one[1]:.2f})" if one else "-" for one in times])
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows)


def main():
    if lacking():
        sys.exit(f"{sys.argv[0]} needs {' '.join(lacking())}")
    suites = os.environ.get("SUITES", "bookworm trixie forky").split()
    results, faults = [], []
    for suite in suites:
        try:
            results.extend(tried_in(suite, sys.argv[1]))
        except Failed as error:
            faults.append(f"{suite} could not be tried: {error}")
    faults += faults_of(results) if results else ["nothing was tried"]
    print(table(results))
    print("\n".join(faults) or f"the wheel works on {', '.join(result['name'] for result in results)}")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
