"""Tests that draw are skipped only where libOSMesa is absent: one that is there and makes no context fails them."""

import ctypes

import pytest


def absent_gl():
    """What is missing; "": nothing."""
    for name in ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
        try:
            ctypes.CDLL(name)
            return ""
        except OSError:
            continue
    return "libOSMesa.so.8 is not installed"


MISSING = absent_gl()
drawing = pytest.mark.skipif(bool(MISSING), reason=MISSING)
