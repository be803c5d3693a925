#!/usr/bin/env python3
"""make.py BUILD OUT: the build folder of the preset wheel as OUT/claque-VERSION-py3-none-manylinux_2_36_x86_64.whl.

Two builds of a commit give equal bytes: nothing depends on the folder, and all times are SOURCE_DATE_EPOCH or that of
the commit."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

import archive
import libraries
import licences

ROOT = pathlib.Path(__file__).resolve().parents[2]
TAG = "py3-none-manylinux_2_36_x86_64"
# Of cmake/install.cmake. The wheel has the module from its sources, and no manual, as pip installs none.
COMPONENTS = ("runtime", "assets", "people", "stage", "command", "mpi")
FONTS = [pathlib.Path("/usr/share/fonts/truetype/dejavu") / name for name in ("DejaVuSans.ttf", "DejaVuSans-Bold.ttf")]
# The package's folder is found on Python's path, not imported: that would load NumPy first.
SCRIPT = """#!python
import os
import sys

for folder in sys.path:
    command = os.path.join(folder, "claque", "bin", "claque")
    if os.path.exists(command):
        os.execv(command, sys.argv)
sys.exit("claque: no folder of Python's path has the package claque with its command; install the wheel again")
"""


def commit_time():
    named = os.environ.get("SOURCE_DATE_EPOCH")
    if named:
        return int(named)
    log = subprocess.run(["git", "-C", ROOT, "log", "-1", "--format=%ct"], capture_output=True, text=True)
    if log.returncode:
        sys.exit("make wheel: there is no commit to take the time from; set SOURCE_DATE_EPOCH")
    return int(log.stdout)


def installed(build, folder):
    for component in COMPONENTS:
        subprocess.run(["cmake", "--install", build, "--prefix", folder, "--component", component], check=True,
                       stdout=subprocess.DEVNULL)


def package(build, folder):
    """Fills the folder claque with all that the module and the command find; returns the Debian packages it is from."""
    with tempfile.TemporaryDirectory() as stage:
        stage = pathlib.Path(stage)
        installed(build, stage)
        for source in sorted((ROOT / "lib/python/claque").glob("*.py")):
            archive.copy(source, folder / source.name)
        own = [path for path in sorted(stage.glob("lib/libclaque*.so.*")) if not path.is_symlink()]
        own += [stage / "bin/claque", *stage.glob("lib/claque/*.so")]
        for path in own:
            name = libraries.soname(path) or path.name
            archive.copy(path, folder / path.relative_to(stage).with_name(name))
        if (stage / "share/claque").exists():
            shutil.copytree(stage / "share/claque", folder / "share/claque")
    for font in FONTS:
        archive.copy(font, folder / "share/claque/fonts" / font.name)
    files = FONTS + libraries.complete(folder) + licences.compiled_in(build)
    return licences.packages(files)


def metadata(project):
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {project['version']}",
             f"Summary: {project['description']}", "License: MIT, and those in the folder licenses",
             f"Requires-Python: {project['requires-python']}"]
    return "\n".join(lines + [f"Requires-Dist: {name}" for name in project["dependencies"]]) + "\n"


def make(build, out):
    project = tomllib.loads((ROOT / "lib/python/pyproject.toml").read_text())["project"]
    built = re.search(r"^CMAKE_PROJECT_VERSION:STATIC=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE)
    if built.group(1) != project["version"]:
        sys.exit(f"make wheel: {build} has version {built.group(1)}, lib/python/pyproject.toml {project['version']}")
    name = f"{project['name']}-{project['version']}"
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder)
        packages = package(build, tree / "claque")
        archive.write(tree / f"{name}.data/scripts/claque", SCRIPT)
        about = tree / f"{name}.dist-info"
        archive.write(about / "METADATA", metadata(project))
        archive.write(about / "WHEEL", f"Wheel-Version: 1.0\nGenerator: claque\nRoot-Is-Purelib: false\nTag: {TAG}\n")
        archive.copy(ROOT / "LICENSE", about / "licenses/LICENSE")
        licences.add(packages, about / "licenses")
        out.mkdir(parents=True, exist_ok=True)
        archive.pack(tree, about, out / f"{name}-{TAG}.whl", commit_time())
    print(f"{out / f'{name}-{TAG}.whl'}: {(out / f'{name}-{TAG}.whl').stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    make(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]))
