"""NumPy arrays over memory that the library owns."""

from ctypes import addressof

import numpy


class Borrowed:
    """A read-only block of the library's memory. It is the base of all arrays over the block and
    keeps the owner alive."""

    def __init__(self, pointer, shape, owner):
        self.owner = owner
        self.__array_interface__ = {"version": 3, "shape": shape, "typestr": numpy.dtype(pointer._type_).str,
                                    "data": (addressof(pointer.contents), True)}


def borrowed(pointer, shape, owner):
    """A read-only array over a ctypes pointer, or None if that is NULL. No element is copied."""
    if not pointer:
        return None
    if 0 in shape:
        return read_only(numpy.empty(shape, pointer._type_))
    return numpy.asarray(Borrowed(pointer, shape, owner))


def read_only(array):
    array.flags.writeable = False
    return array
