#!/usr/bin/env python3
"""run.py SUITE...: runs the commands of README.md on bare Debian systems, and ends with one table.

Each suite is debootstrap's smallest, in a folder of its own, with a clone of this repository. The commands of the first
block run there line by line. Each other block runs in a copy of the system as `make run` left it, so it finds only what
`make run` and its own commands installed. The exit status is 1 if a command failed, if `make run` or `make test` took
longer than MAX_RUN_S (180) or MAX_TEST_S (900) seconds once packages were installed (meant for two idle cores), if
every test was skipped, or if a suite could not be fetched. Needs root, debootstrap and Debian's archive. Logs and
pictures are left in out/bare/SUITE.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import zlib

from system import Bare, Failed, lacking

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LIMITS_S = {"make run": float(os.environ.get("MAX_RUN_S", 180)), "make test": float(os.environ.get("MAX_TEST_S", 900))}
SECTIONS = {"Two commands", "A crowd in your own window", "People who walk and decide"}
GROUPS = {"make run": "run", "make command": "command", "make test": "all"}  # of cmake/setup.sh
# A screen without a monitor for the program of the README; its pixels are read from the file that Xvfb keeps.
SHOW = """
apt-get install -y -qq --no-install-recommends xvfb > /xvfb.log 2>&1
mkdir /screen
Xvfb :9 -screen 0 1024x768x24 -fbdir /screen > /screen.log 2>&1 &
trap "kill $!" EXIT  # the next system's screen has the same number
for second in $(seq 60); do [ -e /screen/Xvfb_screen0 ] || sleep 1; done
export LD_LIBRARY_PATH=$HOME/.local/lib
DISPLAY=:9 timeout 20 ./window > /window.log 2>&1 &
sleep 12
cp /screen/Xvfb_screen0 /screen.xwd
wait $! || [ $? = 124 ]
"""


def blocks_of(page):
    """(section, file that the text before names, language, text) of each block of code of a page."""
    section, file, found = "", "", []
    for part in re.finditer(r"^## ([^\n]*)$|`([\w.]+)`[^`\n]*:$|^```(\w*)\n(.*?)^```$", page, re.M | re.S):
        if part[1]:
            section = part[1]
        elif part[2]:
            file = part[2]
        else:
            found.append((section, file if part[3] == "c" else "", part[3], part[4]))
    return found


def colours_of(screen):
    """How many colours a picture of the X window system (XWD, 32 bits a pixel) has."""
    begin = int.from_bytes(screen[:4], "big") + 12 * int.from_bytes(screen[76:80], "big")
    return len({screen[i : i + 4] for i in range(begin, len(screen) - 3, 4)})


def values_of_png(path):
    """How many different triples the filtered rows of a PNG hold: hardly any, if it shows one colour."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length = int.from_bytes(data[at : at + 4], "big")
        packed += data[at + 8 : at + 8 + length] if data[at + 4 : at + 8] == b"IDAT" else b""
        at += 12 + length
    rows = zlib.decompress(packed)
    return len({rows[i : i + 3] for i in range(0, len(rows) - 2, 3)})


def keep_pictures(bare, logs):
    for picture in [*bare.root.glob("claque/*.png"), *bare.root.glob("claque/out/*.png")]:
        shutil.copy(picture, logs)
        if (values := values_of_png(picture)) < 100:
            raise Failed(f"{picture.name} holds {values} different values, which is no crowd")


def seconds_of(bare, script, log):
    begun = time.monotonic()
    bare.run(script, "/claque", log)
    return time.monotonic() - begun


def log_of(command, logs):
    return logs / f"{command.replace(' ', '-')}.log"


def time_one(bare, command, logs, steps):
    """Adds the seconds of a command of the README, once the packages that it would install are there."""
    log = log_of(command, logs)
    if command in GROUPS:
        bare.run(f"cmake/setup.sh {GROUPS[command]}", "/claque", log.with_suffix(".packages.log"))
    begun = time.monotonic()
    try:
        bare.run(command, "/claque", log)
    finally:  # those of a command that failed are of use, too
        steps[command] = time.monotonic() - begun


def try_window(bare, blocks, steps, logs):
    for _, file, language, text in blocks:
        if language == "c":  # the folder of the sources serves as that of the program
            (bare.root / "claque" / file).write_text(text)
        else:
            steps["window.c"] = seconds_of(bare, text, logs / "window.log")
    bare.run(SHOW, "/claque", logs / "window-shown.log")
    shutil.copy(bare.root / "screen.xwd", logs / "window.xwd")
    colours = colours_of((bare.root / "screen.xwd").read_bytes())
    if colours < 100:
        raise Failed(f"the window of the README shows {colours} colours, which is no crowd")


def try_commands(bare, blocks, steps, logs):
    for _, _, _, text in blocks:
        for line in re.sub(r"\\\n", " ", text).splitlines():
            words = line.split()
            if line in GROUPS:
                time_one(bare, line, logs, steps)
            else:
                name = f"claque {words[1]}"
                seconds = seconds_of(bare, line, logs / f"{name.replace(' ', '-')}.log")
                steps[name] = steps.get(name, 0) + seconds
    keep_pictures(bare, logs)


def tests_of(log):
    """(passed, [failed], [skipped]) of CTest's output."""
    ends = re.findall(r"^ *\d+/\d+ Test +#\d+: (\S+).*?\.{2,} *(\**\w[\w *]*?) +[\d.]+ sec", log, re.M)
    skipped = [name for name, end in ends if "Skipped" in end]
    failed = [name for name, end in ends if end != "Passed" and "Skipped" not in end]
    return len(ends) - len(skipped) - len(failed), failed, skipped


def try_suite(suite, root, logs, row):
    bare = Bare.fetch(suite, root, logs / "debootstrap.log")
    blocks = blocks_of((SOURCE / "README.md").read_text())
    if other := {block[0] for block in blocks} - SECTIONS:
        raise Failed(f"README.md has commands below '{min(other)}', which nothing tries")
    first = next(text for section, _, _, text in blocks if section == "Two commands")
    install, make_run, make_test = (re.sub(r"\s*#.*", "", line) for line in first.splitlines())
    steps = row["steps"]
    bare.run(install, log=logs / "install.log")
    subprocess.run(["git", "clone", "-q", str(SOURCE), str(root / "claque")], check=True)
    time_one(bare, make_run, logs, steps)
    keep_pictures(bare, logs)
    row["compiler"] = bare.run("c++ -dumpfullversion").strip()
    row["cmake"] = bare.run("cmake --version | sed -n '1s/[^0-9]*//p'").strip()
    row["mesa"] = bare.run("dpkg-query -W -f '${Version}' libgl1-mesa-dri | sed 's/-.*//'").strip()
    for section, attempt in [("A crowd in your own window", try_window), ("People who walk and decide", try_commands)]:
        copy = bare.copy(section.split()[-1])
        try:
            attempt(copy, [block for block in blocks if block[0] == section], steps, logs)
        finally:
            copy.remove()
    try:
        time_one(bare, make_test, logs, steps)
    finally:
        passed, failed, skipped = tests_of(log_of(make_test, logs).read_text(errors="replace"))
        row.update(passed=passed, failed=len(failed), skipped=skipped)
        if failed:
            raise Failed(f"{len(failed)} tests failed: {' '.join(failed[:20])}")
    if passed == 0:
        raise Failed("no test passed")
    for command, limit in LIMITS_S.items():
        if steps[command] > limit:
            raise Failed(f"'{command}' took {steps[command]:.0f} s, more than {limit:.0f}")


def table(rows):
    names = list(dict.fromkeys(name for row in rows.values() for name in row["steps"]))
    head = ["suite", "compiler", "CMake", "Mesa", *names, "passed", "failed", "skipped"]
    lines = [head]
    for suite, row in rows.items():
        steps = [f"{row['steps'][name]:.0f} s" if name in row["steps"] else "-" for name in names]
        counts = [str(row.get("passed", "-")), str(row.get("failed", "-")), str(len(row.get("skipped", [])))]
        lines.append([suite, *(row.get(key, "-") for key in ("compiler", "cmake", "mesa")), *steps, *counts])
    widths = [max(len(line[k]) for line in lines) for k in range(len(head))]
    for line in lines:
        print("  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip())
    for suite, row in rows.items():
        for name in row.get("skipped", []):
            print(f"{suite}: skipped {name}")
        if "why" in row:
            print(f"{suite}: FAILED: {row['why']}")


def main():
    suites = sys.argv[1:]
    if not suites:
        sys.exit(__doc__)
    if lacking():
        sys.exit(f"test-bare needs {' '.join(lacking())}")
    rows = {}
    for suite in suites:
        row = rows[suite] = {"steps": {}}
        logs = SOURCE / "out/bare" / suite
        shutil.rmtree(logs, ignore_errors=True)
        logs.mkdir(parents=True)
        folder = pathlib.Path(tempfile.mkdtemp(prefix="bare-"))
        folder.chmod(0o755)
        print(f"{suite}: begun; logs are in {logs.relative_to(SOURCE)}", flush=True)
        try:
            try_suite(suite, folder / suite, logs, row)
        except Failed as failure:
            row["why"] = str(failure)
            print(f"{suite}: {failure}", flush=True)
        finally:
            shutil.rmtree(folder, ignore_errors=True)
    table(rows)
    sys.exit(any("why" in row for row in rows.values()))


if __name__ == "__main__":
    main()
