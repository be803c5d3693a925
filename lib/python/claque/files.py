"""Whole files, which are read where the library takes bytes."""

import os
import stat

from .errors import Error, Status

MOST_BYTES = 4 << 30


def read_file(path, most_bytes=MOST_BYTES):
    """The bytes of a regular file. A name may lead to a pipe without a writer, a device without an end, or a folder;
    with O_NONBLOCK, opening such a pipe does not wait."""
    with open(path, "rb", opener=lambda name, flags: os.open(name, flags | os.O_NONBLOCK)) as file:
        facts = os.fstat(file.fileno())
        if not stat.S_ISREG(facts.st_mode):
            raise Error(f"{path} is not a regular file", Status.IO)
        if facts.st_size > most_bytes:
            raise Error(f"{path} has more than {most_bytes} bytes, the most that is read of it", Status.LIMIT)
        return file.read(most_bytes)
