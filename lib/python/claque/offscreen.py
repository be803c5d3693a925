"""A software GL context whose pixels are a NumPy array: OSMesa, found at run time."""

import ctypes
from ctypes import c_char_p, c_double, c_float, c_int, c_uint, c_void_p

import numpy

from . import abi
from .owner import Closing

_RGBA, _UNSIGNED_BYTE = 0x1908, 0x1401
_DEPTH_TEST, _LIGHTING, _LIGHT0 = 0x0B71, 0x0B50, 0x4000
_AMBIENT, _DIFFUSE, _POSITION, _LIGHT_MODEL_AMBIENT = 0x1200, 0x1201, 0x1203, 0x0B53
_COLOR_DEPTH_BITS = 0x4100


def _osmesa():
    for name in ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
        try:
            library = ctypes.CDLL(name)
        except OSError:
            continue
        library.OSMesaCreateContextExt.restype = c_void_p
        library.OSMesaGetProcAddress.restype = c_void_p
        library.OSMesaGetProcAddress.argtypes = [c_char_p]
        return library
    raise abi.Error("libOSMesa.so.8 was not found (Debian: libosmesa6)")


class Offscreen(Closing):
    """Current on the thread that creates it. clear() begins a picture; `pixels` and picture() return it."""

    def __init__(self, width, height):
        self._mesa = _osmesa()
        self.width, self.height = width, height
        self.pixels = numpy.zeros((height, width, 4), numpy.uint8)  # bottom row first, as in GL
        self._context = c_void_p(self._mesa.OSMesaCreateContextExt(_RGBA, 24, 8, 0, None))
        self.get_proc_address = abi.GetProcAddress(lambda _user, name: self._mesa.OSMesaGetProcAddress(name))
        self.make_current()

    def make_current(self):
        if not self._context or not self._mesa.OSMesaMakeCurrent(
                self._context, self.pixels.ctypes.data_as(c_void_p), _UNSIGNED_BYTE, self.width, self.height):
            raise abi.Error(f"OSMesa cannot create a context of {self.width} x {self.height} pixels")

    def gl(self, name, *arguments):
        """Calls a GL 1.1 function by name. Python floats become GL floats, sequences become arrays of floats."""
        address = self._mesa.OSMesaGetProcAddress(name.encode())
        if not address:
            raise abi.Error(f"this GL has no {name}")
        kinds, values = [], []
        for argument in arguments:
            if isinstance(argument, (list, tuple)):
                kinds.append(c_void_p), values.append(ctypes.cast((c_float * len(argument))(*argument), c_void_p))
            elif isinstance(argument, float):
                kinds.append(c_double if name == "glClearDepth" else c_float), values.append(argument)
            else:
                kinds.append(c_int if argument < 0 else c_uint), values.append(argument)
        return ctypes.CFUNCTYPE(None, *kinds)(address)(*values)

    def clear(self, colour=(0.0, 0.0, 0.0)):
        """Clears colour and depth and sets the viewport to the whole picture."""
        self.make_current()
        self.gl("glViewport", 0, 0, self.width, self.height)
        self.gl("glClearColor", float(colour[0]), float(colour[1]), float(colour[2]), 1.0)
        self.gl("glClear", _COLOR_DEPTH_BITS)
        self.gl("glEnable", _DEPTH_TEST)

    def light(self, to_light=(0.4, 0.8, 0.5), diffuse=(0.75, 0.72, 0.68), ambient=(0.42, 0.43, 0.46)):
        """Sets one light from a direction in eye space."""
        self.gl("glEnable", _LIGHTING)
        self.gl("glEnable", _LIGHT0)
        self.gl("glLightModelfv", _LIGHT_MODEL_AMBIENT, (*map(float, ambient), 1.0))
        self.gl("glLightfv", _LIGHT0, _AMBIENT, (0.0, 0.0, 0.0, 1.0))
        self.gl("glLightfv", _LIGHT0, _DIFFUSE, (*map(float, diffuse), 1.0))
        self.gl("glMatrixMode", 0x1700)
        self.gl("glLoadIdentity")
        self.gl("glLightfv", _LIGHT0, _POSITION, (*map(float, to_light), 0.0))

    def picture(self):
        """The picture, (height, width, 3), top row first: a view of `pixels`, valid until the next drawing."""
        self.gl("glFinish")
        return self.pixels[::-1, :, :3]

    def close(self):
        context, self._context = self._context, None
        if context:
            self._mesa.OSMesaDestroyContext(context)
