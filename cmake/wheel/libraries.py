"""The ELF files of a wheel: what they need and the system need not have goes beside them, under names of their own.

The C and C++ libraries stay the system's, and so does zlib, which OpenGL drivers load too: a second copy would
answer their calls. Libraries that Debian has as archives are in the files already (CLAQUE_PORTABLE)."""

import pathlib
import re
import shutil
import subprocess

SYSTEM = {"libc.so.6", "libm.so.6", "libgcc_s.so.1", "libstdc++.so.6", "ld-linux-x86-64.so.2", "libz.so.1"}
# Opened only by a process that mpirun started, which has it.
GIVEN = {"claque-mpi.so": {"libmpi.so.40"}}


def _dynamic(path, kind):
    text = subprocess.run(["readelf", "-d", path], check=True, capture_output=True, text=True).stdout
    return re.findall(rf"\({kind}\).*\[(.*)\]", text)


def soname(path):
    return next(iter(_dynamic(path, "SONAME")), None)


def needed(path):
    return [name for name in _dynamic(path, "NEEDED") if name not in SYSTEM | GIVEN.get(path.name, set())]


def _own_name(name):
    """libtbb.so.12 as libtbb-claque.so.12, so that no other package's is taken for it."""
    return name.replace(".so", "-claque.so", 1)


def _patch(path, *options):
    subprocess.run(["patchelf", *options, path], check=True)


def complete(folder):
    """Adds what the files of `folder` need, and lets each find it. Returns the files of the system that were added."""
    own = sorted(folder.glob("lib/*.so.*"))
    files = own + [folder / "bin/claque", *sorted(folder.glob("lib/claque/*.so"))]
    names, added = {path.name for path in own}, {}
    for path in files:  # which grows
        for name in needed(path):
            if name in names or name in added:
                continue
            found = subprocess.run(["cc", f"-print-file-name={name}"], check=True, capture_output=True, text=True)
            added[name] = pathlib.Path(found.stdout.strip()).resolve(strict=True)
            files.append(folder / "lib" / name)
            shutil.copyfile(added[name], files[-1])
    for path in files:
        # patchelf 0.14 writes a wrong path where one call does two things, and strip breaks a patched file.
        subprocess.run(["strip", "--strip-unneeded", path], check=True)
        for name in needed(path):
            if name in added:
                _patch(path, "--replace-needed", name, _own_name(name))
        if path.name in added:
            _patch(path, "--set-soname", _own_name(path.name))
        up = {"lib": "$ORIGIN", "bin": "$ORIGIN/../lib", "claque": "$ORIGIN/.."}[path.parent.name]
        _patch(path, "--set-rpath", up)
        if path.name in added:
            path.rename(path.with_name(_own_name(path.name)))
    return list(added.values())
