"""Where the libraries and the command are: in the package, as a wheel holds them; in the prefix that the package is
installed to; or where the system looks."""

import ctypes
import os
import pathlib
import shutil
import sys

from .errors import Error

_PACKAGE = pathlib.Path(__file__).resolve().parent
_PREFIX = pathlib.Path(os.path.normpath(_PACKAGE / "../../../.."))  # of lib/python3/dist-packages/claque


def library_paths():
    """Paths of libclaque, libclaque-assets and libclaque-stage: in the folders of CLAQUE_LIBRARY_DIR, in the package,
    in its prefix, then by the system's search."""
    return [_library_path(stem) for stem in ("claque", "claque-assets", "claque-stage")]


def command_path():
    """The path of the command claque: what CLAQUE_COMMAND names, or in the package, in its prefix, in the virtual
    environment, then in the folders of PATH."""
    folders = [_PACKAGE / "bin", _PREFIX / "bin", pathlib.Path(sys.prefix) / "bin"]
    path = os.pathsep.join([*map(str, folders), os.environ.get("PATH", os.defpath)])
    found = os.environ.get("CLAQUE_COMMAND") or shutil.which("claque", path=path)
    if not found:
        raise Error(f"the command claque is neither in {_listed(folders)} nor on PATH: install it, or say where it is "
                    "in CLAQUE_COMMAND")
    return found


def _library_path(stem):
    named = os.environ.get("CLAQUE_LIBRARY_DIR")
    folders = [*map(pathlib.Path, named.split(os.pathsep) if named else ()), _PACKAGE / "lib", _PREFIX / "lib"]
    for folder in folders:
        for pattern in (f"lib{stem}.so.0", f"lib{stem}.so.0.*", f"lib{stem}.so"):  # wheels hold no links
            found = sorted(folder.glob(pattern))
            if found:
                return str(found[-1])
    name = f"lib{stem}.so.0"
    try:
        ctypes.CDLL(name)
    except OSError as error:
        if str(error).startswith(f"{name}: cannot open"):
            raise Error(f"{name} is neither in {_listed(folders)} nor where the system looks: install it, or say where "
                        "it is in CLAQUE_LIBRARY_DIR") from None
    return name


def _listed(folders):
    return ", ".join(map(str, folders))
