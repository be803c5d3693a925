"""The kinds of OpenGL context that this machine has. Tests that draw run with each; they skip where there is none.

A kind is asked for here without the module: one that is there and makes no context fails the tests."""

import ctypes

import pytest


def has_osmesa():
    for name in ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
        try:
            ctypes.CDLL(name)
            return True
        except OSError:
            continue
    return False


def has_egl():
    """libEGL.so.1 with a driver behind it: a platform without a window system starts."""
    try:
        egl = ctypes.CDLL("libEGL.so.1")
    except OSError:
        return False
    egl.eglGetPlatformDisplay.restype = ctypes.c_void_p
    surfaceless = ctypes.c_void_p(egl.eglGetPlatformDisplay(0x31DD, None, None))
    return bool(surfaceless) and bool(egl.eglInitialize(surfaceless, None, None))


KINDS = [name for name, has in (("osmesa", has_osmesa), ("egl", has_egl)) if has()]
MISSING = "" if KINDS else "neither libOSMesa.so.8 nor libEGL.so.1 with a driver is installed"


def drawing(test):
    """Runs a test with each kind: the fixture gl (conftest.py) sets CLAQUE_CONTEXT."""
    return pytest.mark.skipif(bool(MISSING), reason=MISSING)(pytest.mark.usefixtures("gl")(test))
