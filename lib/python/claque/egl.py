"""EGL, found at run time, without a window system: Mesa's surfaceless platform, else the first device."""

import ctypes
import functools
import os
from ctypes import byref, c_char_p, c_int, c_uint, c_void_p

from .errors import Error

_SURFACELESS, _DEVICE, _OPENGL, _END = 0x31DD, 0x313F, 0x30A2, 0x3038
_WANTED = (c_int * 7)(0x3033, 1, 0x3040, 8, 0x3025, 24, _END)  # pixel buffers, desktop OpenGL, 24 bits of depth
# Red, green, blue, alpha, depth, stencil, samples. EGL sorts deeper colours first, so it is asked for each.
_EXACT = {0x3024: 8, 0x3023: 8, 0x3022: 8, 0x3021: 8, 0x3025: 24, 0x3026: 8, 0x3031: 0}


class _Handle(c_void_p):
    """Stays a pointer when a function returns it; ctypes makes a number of c_void_p."""


@functools.lru_cache(maxsize=None)
def _library():
    try:
        egl = ctypes.CDLL("libEGL.so.1")
    except OSError:
        raise Error("EGL: libEGL.so.1 is missing (Debian: libegl1 and libgl1-mesa-dri)") from None
    for name in ("eglCreateContext", "eglCreatePbufferSurface", "eglGetCurrentContext"):
        getattr(egl, name).restype = _Handle
    egl.eglGetProcAddress.restype, egl.eglGetProcAddress.argtypes = c_void_p, [c_char_p]
    return egl


def _extension(name, result, *kinds):
    address = _library().eglGetProcAddress(name)
    return ctypes.CFUNCTYPE(result, *kinds)(address) if address else lambda *_: None


def _started(platform, native):
    get = _extension(b"eglGetPlatformDisplayEXT", _Handle, c_uint, c_void_p, c_void_p)
    display = get(platform, native, None)
    return display if display and _library().eglInitialize(display, None, None) else None


@functools.lru_cache(maxsize=None)
def _display(wanted):
    """The display of the device of this number; "": the surfaceless one, else that of the first device."""
    devices, count = (c_void_p * 64)(), c_int()
    _extension(b"eglQueryDevicesEXT", c_uint, c_int, c_void_p, c_void_p)(64, devices, byref(count))
    if wanted and not (wanted.isdecimal() and int(wanted) < count.value):
        raise Error(f"EGL: CLAQUE_EGL_DEVICE is '{wanted}', and this machine has {count.value} "
                    f"device{'s' * (count.value != 1)}, counted from 0")
    if wanted:
        display = _started(_DEVICE, devices[int(wanted)])
    else:
        tried = ((_SURFACELESS, None), *((_DEVICE, device) for device in devices[:count.value]))
        display = next(filter(None, (_started(*one) for one in tried)), None)
    if not display:
        driver = os.environ.get("GALLIUM_DRIVER")
        raise Error((f"EGL: device {wanted} of CLAQUE_EGL_DEVICE does not start" if wanted else
                     "EGL: no surfaceless platform and no device (Debian: libgl1-mesa-dri)") +
                    (f"; GALLIUM_DRIVER is '{driver}'" if driver else ""))
    return display


def _config(egl, display):
    configs, count, value = (_Handle * 256)(), c_int(), c_int()
    egl.eglChooseConfig(display, _WANTED, configs, 256, byref(count))
    for config in configs[:count.value]:
        if all(egl.eglGetConfigAttrib(display, config, what, byref(value)) and value.value == bits
               for what, bits in _EXACT.items()):
            return config
    raise Error("EGL: no pixel buffer with desktop OpenGL in this format")


class Egl:
    """A pixel buffer as large as `pixels`, which Offscreen reads."""

    def __init__(self, pixels):
        self._egl, self._display = _library(), _display(os.environ.get("CLAQUE_EGL_DEVICE", ""))
        self.get_proc_address = self._egl.eglGetProcAddress
        self._egl.eglBindAPI(_OPENGL)
        config = _config(self._egl, self._display)
        size = (c_int * 5)(0x3057, pixels.shape[1], 0x3056, pixels.shape[0], _END)
        self._surface = self._egl.eglCreatePbufferSurface(self._display, config, size)
        self._context = self._egl.eglCreateContext(self._display, config, None, None)
        if not (self._surface and self._context):
            self.close()
            raise Error("EGL: no OpenGL context of this size could be made")

    def make_current(self):
        """Releases first: EGL would believe its context still current after OSMesa took over Mesa's dispatch."""
        self._egl.eglBindAPI(_OPENGL)
        self._egl.eglMakeCurrent(self._display, None, None, None)
        return self._egl.eglMakeCurrent(self._display, self._surface, self._surface, self._context)

    def close(self):
        if self._context and self._egl.eglGetCurrentContext().value == self._context.value:
            self._egl.eglMakeCurrent(self._display, None, None, None)
        if self._context:
            self._egl.eglDestroyContext(self._display, self._context)
        if self._surface:
            self._egl.eglDestroySurface(self._display, self._surface)
