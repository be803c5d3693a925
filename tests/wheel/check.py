#!/usr/bin/env python3
"""check.py FILE.whl: the contents of a wheel, its size, its RECORD, and of each ELF file in it the libraries that it
needs, where it looks for them, the versions of symbols, and the names that it gives to the process."""

import base64
import csv
import hashlib
import io
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

MAX_BYTES = 15e6  # without prepared people
NEWEST = {"GLIBC": (2, 36), "GLIBCXX": (3, 4, 30), "CXXABI": (1, 3, 13), "GCC": (12, 0, 0), "ZLIB": (1, 2, 12)}
SYSTEM = {"libc.so.6", "libm.so.6", "libgcc_s.so.1", "libstdc++.so.6", "ld-linux-x86-64.so.2", "libz.so.1"}
# Libraries that drivers of OpenGL load. A name of theirs in ours would be taken in place of their own.
DRIVERS = re.compile(r"(inflate|deflate|crc32|adler32|gz[a-z]+$|XML_|FT_|Fc[A-Z]|cairo_|pixman_|png_|Brotli|sqlite3_|"
                     r"WebP|xcb_|X[A-Z][a-z]|drm[A-Z])")
FILES = ["claque/__init__.py", "claque/abi.py", "claque/bin/claque", "claque/lib/libclaque.so.0",
         "claque/lib/libclaque-assets.so.0", "claque/lib/libclaque-stage.so.0",
         "claque/share/claque/fonts/DejaVuSans.ttf", "claque/share/claque/fonts/DejaVuSans-Bold.ttf",
         "{data}/scripts/claque", "{info}/METADATA", "{info}/WHEEL", "{info}/RECORD", "{info}/licenses/LICENSE",
         "{info}/licenses/packages.txt"]
# A licence for each of these, whichever way they come in.
HELD = ["assimp", "brotli", "cairo", "cli11", "draco", "expat", "fontconfig", "fonts-dejavu", "freetype", "glm",
        "imgui", "libmd", "libpng1.6", "libsqlite3|sqlite3", "libstb", "libwebp", "meshoptimizer", "minizip",
        "nlohmann-json3", "openmesh", "pixman", "recastnavigation", "onetbb", "tomlplusplus", "zlib"]

faults = []


def demand(holds, sentence):
    if not holds:
        faults.append(sentence)


def read(tool, *options):
    return subprocess.run([tool, *options], check=True, capture_output=True, text=True).stdout


def check_record(wheel, info):
    rows = list(csv.reader(io.StringIO(wheel.read(f"{info}/RECORD").decode())))
    demand(sorted(row[0] for row in rows) == sorted(wheel.namelist()), "RECORD lists other files than the wheel holds")
    for name, digest, size in rows:
        if name != f"{info}/RECORD":
            data = wheel.read(name)
            hashed = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            demand((digest, size) == (f"sha256={hashed}", str(len(data))), f"RECORD is wrong about {name}")


def check_names(wheel, name, info):
    names = wheel.namelist()
    _, version, python, abi, system = name.removesuffix(".whl").split("-")
    demand((python, abi, system) == ("py3", "none", "manylinux_2_36_x86_64"), f"{name} has another tag")
    for file in FILES:
        file = file.format(data=f"claque-{version}.data", info=info)
        demand(file in names, f"{file} is not there")
    ours = [file for file in names if not file.startswith(info)]
    demand(names[:len(ours)] == sorted(ours) and names[-1] == f"{info}/RECORD", "the files are not sorted")
    demand(len({entry.date_time for entry in wheel.infolist()}) == 1, "the files have several times")
    for entry in wheel.infolist():
        runs = entry.filename in (f"claque-{version}.data/scripts/claque", "claque/bin/claque")
        demand(entry.external_attr >> 16 == (0o100755 if runs else 0o100644), f"{entry.filename} has other modes")
    about = wheel.read(f"{info}/METADATA").decode()
    for line in ("Name: claque", f"Version: {version}", "Requires-Dist: numpy"):
        demand(line in about.splitlines(), f"METADATA does not say {line}")
    demand(f"Tag: {python}-{abi}-{system}" in wheel.read(f"{info}/WHEEL").decode(), "WHEEL has another tag")
    demand(any(re.fullmatch(r"claque/share/claque/people/.*\.clq", file) for file in names), "there are no people")
    people = sum(entry.compress_size for entry in wheel.infolist() if "/people/" in entry.filename)
    size = sum(entry.compress_size for entry in wheel.infolist()) - people
    demand(size <= MAX_BYTES, f"{size} bytes without prepared people are more than {MAX_BYTES:.0f}")
    print(f"{name}: {len(names)} files, {size / 1e6:.1f} MB and {people / 1e6:.1f} MB of prepared people")


def check_licences(wheel, info):
    rows = wheel.read(f"{info}/licenses/packages.txt").decode().splitlines()[1:]
    for row in rows:
        demand(f"{info}/licenses/{row.split()[0]}.txt" in wheel.namelist(), f"no licence text of {row}")
    for held in HELD:
        demand(any(re.search(held, row) for row in rows), f"no package with code of {held} is listed")


def check_elf(path, folder, names):
    where = path.relative_to(folder).as_posix()
    dynamic = read("readelf", "-Wd", path)
    needed = set(re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic))
    ours = needed - SYSTEM - ({"libmpi.so.40"} if path.name == "claque-mpi.so" else set())
    up = {"claque/lib": "$ORIGIN", "claque/bin": "$ORIGIN/../lib", "claque/lib/claque": "$ORIGIN/.."}
    demand(re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", dynamic) == [up[path.relative_to(folder).parent.as_posix()]]
           and "(RPATH)" not in dynamic, f"{where} looks for libraries elsewhere")
    for name in ours:
        demand(f"claque/lib/{name}" in names, f"{where} needs {name}, which the wheel lacks")
    if path.suffix != ".so" and path.parent.name == "lib":
        demand(re.findall(r"\(SONAME\).*\[(.*)\]", dynamic) == [path.name], f"{where} calls itself otherwise")
    demand("claque" in path.name, f"{where} has a name that another package may have too")
    wanted = read("readelf", "-WV", path).split("needs section")[-1]
    for kind, number in re.findall(r"Name: ([A-Z]+)_([0-9.]+)", wanted):
        demand(kind in NEWEST and tuple(map(int, number.split("."))) <= NEWEST[kind],
               f"{where} needs {kind}_{number}, which Debian 12 does not promise")
    symbols = read("readelf", "-W", "--dyn-syms", path)
    given = [row.split()[7].split("@")[0] for row in symbols.splitlines()
             if re.match(r"\s*\d+: ", row) and len(row.split()) > 7 and row.split()[6] != "UND"]
    for name in given:
        demand(not DRIVERS.match(name), f"{where} gives {name} to OpenGL drivers")
        if re.fullmatch(r"libclaque(-assets|-stage)?\.so\.\d+", path.name):
            demand(name.startswith("clq_"), f"{where} exports {name}")
    demand(".symtab" not in read("readelf", "-WS", path), f"{where} is not stripped")


def check_wheel(file):
    with zipfile.ZipFile(file) as wheel, tempfile.TemporaryDirectory() as folder:
        info = "-".join(file.name.split("-")[:2]) + ".dist-info"
        check_names(wheel, file.name, info)
        check_record(wheel, info)
        check_licences(wheel, info)
        wheel.extractall(folder)
        tree = str(pathlib.Path(__file__).resolve().parents[2]).encode()
        elves = 0
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.is_file():
                data = path.read_bytes()
                demand(tree not in data, f"{path.relative_to(folder)} has the path of the sources in it")
                if data.startswith(b"\x7fELF"):
                    check_elf(path, pathlib.Path(folder), wheel.namelist())
                    elves += 1
        print(f"{elves} ELF files")


if __name__ == "__main__":
    check_wheel(pathlib.Path(sys.argv[1]))
    print("\n".join(faults) or "as it should be")
    sys.exit(bool(faults))
