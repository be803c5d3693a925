"""Folders with scripts of this tree, and tools of their own."""
import os
import pathlib
import shutil
import subprocess

SOURCE = pathlib.Path(__file__).resolve().parents[2]


def copy(folder, *files):
    for file in files:
        to = folder / file
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(SOURCE / file, to)


def write_tool(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("#!/bin/sh\n" + text)
    path.chmod(0o755)


def run(folder, *command, **variables):
    """The exit status and all that was said; `tools` of the folder come first in PATH."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("GIT_", "MAKE"))}
    environment |= {"PATH": f"{folder.parent / 'tools'}:{environment['PATH']}", **variables}
    done = subprocess.run(command, cwd=folder, env=environment, text=True, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode, done.stdout
