"""The structs of claque/visibility.h."""

from ctypes import POINTER, c_bool, c_double, c_float, c_uint8, c_uint32

from .abi import STRUCTS, Camera, Sized


class VisibilityDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("first_number", c_uint32), ("upper_bits", c_bool),
                ("drawn", POINTER(c_uint8))]


class Pixels(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("width_px", c_uint32), ("height_px", c_uint32),
                ("first_number", c_uint32), ("numbers", POINTER(c_uint32))]


class PixelChannels(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("individuals", POINTER(c_uint32)), ("actors", POINTER(c_uint32)),
                ("parts", POINTER(c_uint32)), ("zones", POINTER(c_uint32)), ("triangles", POINTER(c_uint32)),
                ("barycentric", POINTER(c_float)), ("depth_m", POINTER(c_float)), ("positions", POINTER(c_double)),
                ("normals", POINTER(c_float))]


class FlowDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("time_s", c_double), ("camera", Camera)]


STRUCTS.update({
    "clq_visibility_def": VisibilityDef, "clq_pixels": Pixels, "clq_pixel_channels": PixelChannels,
    "clq_flow_def": FlowDef,
})
