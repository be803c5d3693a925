"""The command claque, for tests in which it draws: they are skipped where it or OpenGL is absent, and say which."""

import os
import shutil

import pytest

import claque

COMMAND = os.environ.get("CLAQUE_COMMAND")
try:
    claque.Offscreen(8, 8).close()
    MISSING = "" if COMMAND and shutil.which(COMMAND) else "CLAQUE_COMMAND names no command"
except claque.Error as error:
    MISSING = str(error)
needs_command = pytest.mark.skipif(bool(MISSING), reason=MISSING)
