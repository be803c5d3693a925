"""How calls end (claque/base.h)."""

import enum


class Status(enum.IntEnum):
    OK = 0
    ARGUMENT = 1
    STRUCT_SIZE = 2
    STALE_ID = 3
    OUT_OF_MEMORY = 4
    LIMIT = 5
    FORMAT = 6
    UNSUPPORTED = 7
    KEY_RESOLUTION = 8
    GL_MISSING = 9
    GL_STATE = 10
    BUSY = 11
    IN_USE = 12
    IO = 13


class Error(Exception):
    """A call of the library failed, or a library or OpenGL was not found. `status` is None in the second case."""

    def __init__(self, text, status=None):
        super().__init__(text)
        self.status = status
