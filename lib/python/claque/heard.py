"""Warnings of the library as Python's (warnings.warn)."""

import os
import sys
import threading
import warnings

_HERE = os.path.dirname(__file__)


class _Heard(threading.local):
    """Those of the call that a thread makes. They are given after it, because no exception leaves a callback."""

    def __init__(self):
        self.texts = []

    def warn(self):
        """Gives them at the line outside this package that led here."""
        if not self.texts:
            return
        texts, self.texts = self.texts, []
        depth, frame = 1, sys._getframe(0)
        while frame.f_back and os.path.dirname(frame.f_code.co_filename) == _HERE:
            depth, frame = depth + 1, frame.f_back
        for text in texts:
            warnings.warn(text, UserWarning, stacklevel=depth)


heard = _Heard()
