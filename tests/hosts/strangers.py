#!/usr/bin/env python3
"""Runs claque in programs and scenegraphs of others on a screen of its own, and ends with one table.

strangers.py BUILD OUT [HOST...]: the folder of the build, a folder for pictures; without names, all hosts. A host that
is not installed is skipped and named in the table, with its package. The exit status is 1 if a host failed.
"""
import ctypes.util
import pathlib
import re
import shutil
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import screen
import sumo

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
BUILD, OUT = (pathlib.Path(a).resolve() for a in sys.argv[1:3])


def needs(**programs):
    """The first of these programs that is not there, and its package."""
    for program, package in programs.items():
        if not shutil.which(program.replace("_", "-")):
            return f"{program.replace('_', '-')} is not installed (Debian: {package})"
    return ""


def no_plugin():
    return "" if list(BUILD.glob("samples/osgPlugins-*/osgdb_claque.so")) else \
        "osgdb_claque was not built (Debian: libopenscenegraph-dev)"


def check_test(name):
    """Runs a test of this build; a test that skips is a failure here, where its host is there."""
    run = subprocess.run([BUILD / "tests/hosts" / name], capture_output=True, text=True)
    assert run.returncode == 0 and "[  SKIPPED ]" not in run.stdout, run.stdout + run.stderr
    return re.search(r"\[  PASSED  \] (.*)\.", run.stdout).group(1)


def python_with_vtk():
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import numpy, vtkmodules"], capture_output=True).returncode == 0:
            return python
    return ""


def no_vtk():
    if not python_with_vtk():
        return "no Python with VTK (Debian: python3-vtk9)"
    if not ctypes.util.find_library("glut"):
        return "libglut is not installed (Debian: libglut3.12)"
    return needs(Xvfb="xvfb")


def check_vtk():
    libraries = ":".join(str(BUILD / "lib" / folder) for folder in ("api", "api/assets", "stage"))
    with screen.Screen() as shown:
        environment = dict(shown.environment, CLAQUE_LIBRARY_DIR=libraries, PYTHONPATH=str(SOURCE / "lib/python"))
        run = subprocess.run([python_with_vtk(), "-B", SOURCE / "tests/hosts/vtk_check.py", OUT / "vtk.png"],
                             env=environment, capture_output=True, text=True, timeout=300)
    assert run.returncode == 0, run.stdout + run.stderr
    return run.stdout.strip()


HOSTS = {
    "sumo-gui": (lambda: no_plugin() or needs(sumo_gui="sumo", netgenerate="sumo", Xvfb="xvfb"),
                 lambda: sumo.check_sumo(BUILD / "samples", OUT)),
    "osgviewer": (lambda: no_plugin() or needs(osgviewer="openscenegraph", Xvfb="xvfb"),
                  lambda: sumo.check_osgviewer(BUILD / "samples", OUT, SOURCE / "samples/scenarios")),
    "Coin": (lambda: "" if (BUILD / "tests/hosts/hosts_coin_test").exists() else
             "samples/hosts/coin was not built (Debian: libcoin-dev)", lambda: check_test("hosts_coin_test")),
    "VTK": (no_vtk, check_vtk),
}


def main():
    OUT.mkdir(parents=True, exist_ok=True)
    rows, failed = [], False
    for name in sys.argv[3:] or HOSTS:
        absent, check = HOSTS[name]
        start = time.monotonic()
        why = absent()
        if why:
            rows.append((name, "skipped", why))
            continue
        try:
            result = ("passed", check())
        except Exception as failure:
            result, failed = ("FAILED", str(failure)), True
        rows.append((name, result[0], f"{result[1]} ({time.monotonic() - start:.0f} s)"))
    print(f"{'host':12}{'result':10}what")
    for name, result, what in rows:
        print(f"{name:12}{result:10}{what}")
    return failed


if __name__ == "__main__":
    sys.exit(main())
