"""OSMesa, found at run time: Mesa drawing into an array."""

import ctypes
import functools
import os
from ctypes import c_char_p, c_void_p

from .errors import Error

_RGBA, _UNSIGNED_BYTE = 0x1908, 0x1401
_DRIVERS = ("llvmpipe", "softpipe")  # it ends the process where it is told of others


@functools.lru_cache(maxsize=None)
def _library():
    for name in ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
        try:
            library = ctypes.CDLL(name)
        except OSError:
            continue
        library.OSMesaCreateContextExt.restype = c_void_p
        library.OSMesaGetCurrentContext.restype = c_void_p
        library.OSMesaGetProcAddress.restype = c_void_p
        library.OSMesaGetProcAddress.argtypes = [c_char_p]
        return library
    raise Error("OSMesa: libOSMesa.so.8 is missing (Debian: libosmesa6)")


class Osmesa:
    """Draws into `pixels`."""

    def __init__(self, pixels):
        self._mesa, self._pixels = _library(), pixels
        driver = os.environ.get("GALLIUM_DRIVER")
        if driver and driver not in _DRIVERS:
            raise Error(f"OSMesa: GALLIUM_DRIVER is '{driver}'; OSMesa draws with {' or '.join(_DRIVERS)}")
        self.get_proc_address = self._mesa.OSMesaGetProcAddress
        self._context = c_void_p(self._mesa.OSMesaCreateContextExt(_RGBA, 24, 8, 0, None))
        if not self._context:
            raise Error("OSMesa: no context could be made")

    def make_current(self):
        height, width, _ = self._pixels.shape
        return self._mesa.OSMesaMakeCurrent(self._context, self._pixels.ctypes.data_as(c_void_p), _UNSIGNED_BYTE,
                                            width, height)

    def close(self):
        if self._mesa.OSMesaGetCurrentContext() == self._context.value:
            self._mesa.OSMesaMakeCurrent(None, None, _UNSIGNED_BYTE, 0, 0)
        self._mesa.OSMesaDestroyContext(self._context)
