"""The command claque, for tests in which it draws: they are skipped where it or OpenGL is absent, and say which."""

import os

import pytest

import drawing

COMMAND = os.environ.get("CLAQUE_COMMAND")
MISSING = drawing.MISSING or ("" if COMMAND else "CLAQUE_COMMAND is not set")
needs_command = pytest.mark.skipif(bool(MISSING), reason=MISSING)
