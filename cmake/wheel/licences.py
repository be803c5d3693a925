"""The licence texts of the Debian packages that a wheel holds: libraries, archives, fonts, and headers with code."""

import pathlib
import re
import subprocess

import archive

# Headers of these packages declare only; or they are the compilers' own, whose licences except what they compile.
INTERFACES = re.compile(r"libc6-dev|linux-libc-dev|libstdc\+\+-12-dev|libgcc-12-dev|libsdl2-dev|libvncserver-dev|"
                        r"libopenmpi-dev|libgl-dev|libgles-dev|libegl-dev|libglx-dev|libx11-dev|x11proto-dev|mesa-.*")


def compiled_in(build):
    """Files of the system that the compiler read, and the archives that the linker took members from."""
    headers = subprocess.run(["ninja", "-C", build, "-t", "deps"], check=True, capture_output=True, text=True).stdout
    files = {line.strip() for line in headers.splitlines() if line.startswith("    /usr/")}
    for text in build.glob("*.map"):
        files |= set(re.findall(r"^(/usr/\S+\.a)\(", text.read_text(), re.MULTILINE))
    return [pathlib.Path(name).resolve() for name in files]


def packages(files):
    """The packages that own `files`: source package and version, and their names; INTERFACES left out."""
    wanted = sorted({str(path) for path in files})
    found = subprocess.run(["dpkg-query", "-S", *wanted], capture_output=True, text=True).stdout
    owners = dict(line.rsplit(": ", 1)[::-1] for line in found.splitlines())
    lost = [path for path in wanted if path not in owners]
    if lost:
        raise SystemExit(f"make wheel: no Debian package owns {lost[0]}, so its licence is not known")
    names = {name.split(":")[0] for owner in owners.values() for name in owner.split(", ")}
    sources = {}
    for name in sorted(name for name in names if not INTERFACES.fullmatch(name)):
        source = subprocess.run(["dpkg-query", "-W", "-f", "${source:Package} ${source:Version}\n", name], check=True,
                                capture_output=True, text=True).stdout.splitlines()[0]
        sources.setdefault(source, []).append(name)
    return sources


def add(sources, folder):
    """A text for each source package, the texts that these name, and a list by which Debian has the sources."""
    rows, common = [], set()
    for source, names in sorted(sources.items()):
        text = pathlib.Path(f"/usr/share/doc/{names[0]}/copyright").read_text()
        archive.write(folder / f"{source.split()[0]}.txt", text)
        common |= set(re.findall(r"/usr/share/common-licenses/([A-Za-z]+(?:-\d+(?:\.\d+)*)?)", text))
        rows.append(f"{source}: {' '.join(names)}")
    for name in sorted(common):
        archive.copy(pathlib.Path("/usr/share/common-licenses") / name, folder / "common-licenses" / name)
    archive.write(folder / "packages.txt", "Source packages of Debian that this wheel has code or data of, with their "
                  "versions: the packages that it was made with\n" + "\n".join(rows) + "\n")
