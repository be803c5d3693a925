"""Where the module finds the libraries and the command: in a wheel's package, an installed prefix, an environment."""

import ctypes
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

import claque
from claque import places

PACKAGE = pathlib.Path(claque.__file__).parent
PRINT = ("import claque; from claque.places import command_path; "
         "print(*claque.library_paths(), command_path(), sep='\\n')")


def copied(folder, libraries, command, name=lambda path: path.name.split(".so")[0] + ".so.0"):
    """A copy of the module in `folder`, with the libraries and a command of one line in others; all their paths."""
    shutil.copytree(PACKAGE, folder / "claque", ignore=shutil.ignore_patterns("__pycache__"))
    libraries.mkdir(parents=True, exist_ok=True)
    made = [shutil.copy(path, libraries / name(pathlib.Path(path).resolve())) for path in claque.library_paths()]
    return [*map(str, made), str(a_command(command))]


def a_command(path):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("#!/bin/sh\n")
    path.chmod(0o755)
    return path


def said(folder, script, python=sys.executable, **more):
    environment = {name: value for name, value in os.environ.items()
                   if name not in ("CLAQUE_LIBRARY_DIR", "CLAQUE_COMMAND", "LD_LIBRARY_PATH")}
    return subprocess.run([python, "-B", "-c", script], env={**environment, "PYTHONPATH": str(folder), **more},
                          check=True, capture_output=True, text=True).stdout.splitlines()


@pytest.mark.parametrize("name", [lambda path: path.name, lambda path: path.name.split(".so")[0] + ".so.0"])
def test_a_package_brings_its_libraries_and_command(tmp_path, name):
    package = tmp_path / "claque"
    paths = copied(tmp_path, package / "lib", package / "bin/claque", name)
    assert said(tmp_path, PRINT) == paths
    assert said(tmp_path, "import claque; claque.Template.builtin(claque.Context(), 'citizen'); print('made')")


def test_a_prefix_has_them_beside_the_module(tmp_path):
    modules = tmp_path / "lib/python3/dist-packages"
    paths = copied(modules, tmp_path / "lib", tmp_path / "bin/claque")
    assert said(modules, PRINT) == paths


def test_what_the_environment_names_comes_first(tmp_path):
    copied(tmp_path, tmp_path / "claque/lib", tmp_path / "claque/bin/claque")
    named = os.pathsep.join(str(pathlib.Path(path).parent) for path in claque.library_paths())
    found = said(tmp_path, PRINT, CLAQUE_LIBRARY_DIR=named, CLAQUE_COMMAND="another")
    assert found == [*claque.library_paths(), "another"]


def test_an_environment_that_is_not_activated_has_the_command(tmp_path):
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", tmp_path], check=True)
    command = a_command(tmp_path / "bin/claque")
    script = "from claque.places import command_path; print(command_path())"
    assert said(PACKAGE.parent, script, python=tmp_path / "bin/python") == [str(command)]


def test_folders_are_named_where_nothing_is_found(monkeypatch, tmp_path):
    def absent(name, **_):
        raise OSError(f"{name}: cannot open shared object file: No such file or directory")

    monkeypatch.setattr(ctypes, "CDLL", absent)
    monkeypatch.setattr(places, "_PREFIX", tmp_path / "prefix")
    monkeypatch.setattr(sys, "prefix", str(tmp_path / "environment"))
    for name, value in (("CLAQUE_LIBRARY_DIR", f"{tmp_path}/a:{tmp_path}/b"), ("CLAQUE_COMMAND", ""), ("PATH", "")):
        monkeypatch.setenv(name, value)
    with pytest.raises(claque.Error) as refused:
        claque.library_paths()
    assert str(refused.value) == (
        f"libclaque.so.0 is neither in {tmp_path}/a, {tmp_path}/b, {PACKAGE}/lib, {tmp_path}/prefix/lib nor where the "
        "system looks: install it, or say where it is in CLAQUE_LIBRARY_DIR")
    with pytest.raises(claque.Error) as refused:
        places.command_path()
    assert str(refused.value) == (
        f"the command claque is neither in {PACKAGE}/bin, {tmp_path}/prefix/bin, {tmp_path}/environment/bin nor on "
        "PATH: install it, or say where it is in CLAQUE_COMMAND")


def test_a_library_that_cannot_be_loaded_is_named(tmp_path):
    copied(tmp_path, tmp_path / "claque/lib", tmp_path / "claque/bin/claque")
    broken = tmp_path / "claque/lib/libclaque.so.0"
    broken.write_bytes(b"no library")
    script = "import claque\ntry:\n    claque.Context()\nexcept claque.Error as error:\n    print(error)"
    assert said(tmp_path, script)[0].startswith(f"{broken} cannot be loaded: ")
