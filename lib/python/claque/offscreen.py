"""A software GL context whose pixels are a NumPy array."""

import ctypes
import os
from ctypes import c_char_p, c_double, c_float, c_int, c_uint, c_void_p

import numpy

from . import abi
from .egl import Egl
from .osmesa import Osmesa
from .owner import Closing

_LARGEST_SIDE_PX = 16384  # OSMesa accepts larger ones and draws them wrong
_RGBA, _UNSIGNED_BYTE, _RENDERER, _MAX_VIEWPORT_DIMS = 0x1908, 0x1401, 0x1F01, 0x0D3A
_CLIENT_PIXEL_STORE_BIT, _PIXEL_MODE_BIT = 1, 0x20
# What glReadPixels heeds, and its defaults. Scales have even names; 0x0D16 and 0x0D17 are the zooms of glDrawPixels.
_PACKING = {0x0D00: 0, 0x0D01: 0, 0x0D02: 0, 0x0D03: 0, 0x0D04: 0, 0x0D05: 1}
_TRANSFER = {name: float(name >= 0x0D14 and name % 2 == 0)
             for name in range(0x0D10, 0x0D20) if name not in (0x0D16, 0x0D17)}
_DEPTH_TEST, _LIGHTING, _LIGHT0 = 0x0B71, 0x0B50, 0x4000
_AMBIENT, _DIFFUSE, _POSITION, _LIGHT_MODEL_AMBIENT = 0x1200, 0x1201, 0x1203, 0x0B53
_COLOR_DEPTH_BITS = 0x4100
_KINDS = {"osmesa": Osmesa, "egl": Egl}


def _opened(pixels):
    """A context of the kind that CLAQUE_CONTEXT names, or the first that this machine has."""
    named = os.environ.get("CLAQUE_CONTEXT")
    if named and named not in _KINDS:
        raise abi.Error(f"CLAQUE_CONTEXT is '{named}'; Python draws with {' or '.join(_KINDS)}")
    why_not = []
    for name in [named] if named else _KINDS:
        try:
            return _KINDS[name](pixels)
        except abi.Error as error:
            why_not.append(str(error))
    raise abi.Error("; ".join(why_not))


class Offscreen(Closing):
    """A context of OSMesa, else of EGL without a window system; CLAQUE_CONTEXT chooses one (osmesa, egl). It is current
    on the thread that creates it. clear() begins a picture, `pixels` and picture() return it, and all three make it
    current. `renderer`: the name that OpenGL gives itself."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self._context = None
        if not (1 <= width <= _LARGEST_SIDE_PX and 1 <= height <= _LARGEST_SIDE_PX):
            raise abi.Error(f"a picture of {width} x {height} pixels; each side must be 1 to {_LARGEST_SIDE_PX}")
        self._pixels = numpy.zeros((height, width, 4), numpy.uint8)
        self._context = _opened(self._pixels)
        find = self._context.get_proc_address
        self.get_proc_address = abi.GetProcAddress(lambda _user, name: find(name))
        self.make_current()
        self._check()

    def _check(self):
        get_string = self._context.get_proc_address(b"glGetString")
        self.renderer = ctypes.CFUNCTYPE(c_char_p, c_uint)(get_string)(_RENDERER).decode()
        driver = os.environ.get("GALLIUM_DRIVER", "")
        if self.renderer.startswith(("llvmpipe", "softpipe")) and not self.renderer.startswith(driver):
            raise abi.Error(f"GALLIUM_DRIVER is '{driver}', and OpenGL drew with {self.renderer} instead")
        most = (c_int * 2)()
        self.gl("glGetIntegerv", _MAX_VIEWPORT_DIMS, most)
        if self.width > most[0] or self.height > most[1]:
            raise abi.Error(f"{self.width} x {self.height} pixels are more than the {most[0]} x {most[1]} of "
                            f"{self.renderer}")

    def make_current(self):
        if not self._context or not self._context.make_current():
            raise abi.Error(f"no context of {self.width} x {self.height} pixels could be made current")

    def gl(self, name, *arguments):
        """Calls a GL 1.1 function by name. Python floats become GL floats, sequences become arrays of floats; ctypes
        arrays and pointers stay."""
        address = self._context.get_proc_address(name.encode())
        if not address:
            raise abi.Error(f"this GL has no {name}")
        kinds, values = [], []
        for argument in arguments:
            if isinstance(argument, (list, tuple)):
                argument = (c_float * len(argument))(*argument)
            if isinstance(argument, (ctypes.Array, c_void_p)):
                kinds.append(c_void_p), values.append(ctypes.cast(argument, c_void_p))
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

    @property
    def pixels(self):
        """RGBA, (height, width, 4), bottom row first, as in GL: always the same array, valid until the next drawing."""
        self.make_current()
        self.gl("glFinish")
        if isinstance(self._context, Egl):
            self._read()
        return self._pixels

    def _read(self):
        self.gl("glPushClientAttrib", _CLIENT_PIXEL_STORE_BIT)
        self.gl("glPushAttrib", _PIXEL_MODE_BIT)
        for name, value in _PACKING.items():
            self.gl("glPixelStorei", name, value)
        for name, value in _TRANSFER.items():
            self.gl("glPixelTransferf", name, value)
        self.gl("glReadPixels", 0, 0, self.width, self.height, _RGBA, _UNSIGNED_BYTE,
                self._pixels.ctypes.data_as(c_void_p))
        self.gl("glPopAttrib")
        self.gl("glPopClientAttrib")

    def picture(self):
        """The picture, (height, width, 3), top row first: a view of `pixels`, valid until the next drawing."""
        return self.pixels[::-1, :, :3]

    def close(self):
        context, self._context = self._context, None
        if context:
            context.close()
