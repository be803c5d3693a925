"""The C ABI: where the libraries are, their structs in the order of the headers, and calls that raise.

tests/python/test_layout.py holds every struct here against the compiler's own layout of the headers.
"""

import ctypes
import ctypes.util
import enum
import os
import pathlib
from ctypes import (POINTER, Structure, c_char_p, c_double, c_float, c_int, c_int32, c_uint8, c_uint16, c_uint32,
                    c_uint64, c_void_p)

NONE = 0xFFFFFFFF
RANDOM = 0xFFFFFFFF


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
    """A call of the library that failed, or a library that is not there. `status` is None in the second case."""

    def __init__(self, text, status=None):
        super().__init__(text)
        self.status = status


class Allocator(Structure):
    _fields_ = [("user", c_void_p), ("allocate", c_void_p), ("release", c_void_p)]


LogWrite = ctypes.CFUNCTYPE(None, c_void_p, c_int, c_char_p)


class Log(Structure):
    _fields_ = [("user", c_void_p), ("write", LogWrite)]


class Tasks(Structure):
    _fields_ = [("user", c_void_p), ("run", c_void_p)]


class ContextDef(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("allocator", Allocator), ("log", Log), ("tasks", Tasks)]


class ActorId(Structure):
    _fields_ = [("index1", c_uint32), ("generation", c_uint32)]


class Transform(Structure):
    _fields_ = [("position", c_double * 3), ("orientation_xyzw", c_float * 4), ("scale", c_float)]


class Play(Structure):
    _fields_ = [("clip", c_uint32), ("start_s", c_double), ("speed", c_float), ("phase_s", c_float)]


class ActorDef(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("tmpl", c_void_p), ("transform", Transform), ("play", Play), ("seed", c_uint64),
                ("texture_set", c_uint32)]



class Camera(Structure):
    _fields_ = [("eye", c_double * 3), ("rotation_xyzw", c_float * 4), ("projection", c_float * 16)]


class HsbRange(Structure):
    _fields_ = [("hue_min_deg", c_float), ("hue_max_deg", c_float), ("saturation_min", c_float),
                ("saturation_max", c_float), ("brightness_min", c_float), ("brightness_max", c_float)]


class ClipInfo(Structure):
    _fields_ = [("name", c_char_p), ("start_s", c_float), ("duration_s", c_float), ("channel_count", c_uint32),
                ("rate_hz", c_float), ("error_m", c_float), ("error_rad", c_float), ("kept_count", c_uint32),
                ("bytes", c_uint64)]


class ZoneInfo(Structure):
    _fields_ = [("name", c_char_p), ("colour", c_float * 3), ("range", HsbRange), ("clean_count", c_uint32)]


class TemplateInfo(Structure):
    _fields_ = [("name", c_char_p)] + [(name, c_uint32) for name in (
        "node_count", "joint_count", "clip_count", "zone_count", "texture_count", "surface_count", "vertex_count",
        "fused_vertex_count", "triangle_count", "clean_count", "dirty_count", "coincident_count",
        "fused_triangle_count")] + [
            ("dirty_zone_mean", c_float), ("max_influences", c_uint32), ("sklsroot_centre", c_float * 3),
            ("sklsroot_radius", c_float), ("dof_count", c_uint32), ("level_count", c_uint32),
            ("part_count", c_uint32), ("bytes", c_uint64), ("marker_count", c_uint32),
            ("texture_set_count", c_uint32)]


class Mesh(Structure):
    _fields_ = [("vertex_count", c_uint32), ("positions", POINTER(c_float)), ("normals", POINTER(c_float)),
                ("uvs", POINTER(c_float)), ("colours", POINTER(c_uint8)), ("influence_count", c_uint32),
                ("bin_count", c_uint32), ("morph_count", c_uint32), ("normals_by_inverse", c_int32)]


class Triangles(Structure):
    _fields_ = [("texture", c_uint32), ("double_sided", c_int32), ("zone", c_uint32), ("index_count", c_uint32),
                ("indices", POINTER(c_uint32))]


class DrawnActor(Structure):
    _fields_ = [("actor", ActorId), ("tmpl", c_void_p), ("level", c_uint32), ("texture_set", c_uint32),
                ("model_view", c_float * 16), ("eye_distance_m", c_float), ("mirrored", c_int32),
                ("shadow_only", c_int32), ("parts", c_uint64), ("vertex_count", c_uint32), ("joint_count", c_uint32),
                ("morph_weight_count", c_uint32), ("zone_count", c_uint32)]


class ViewStats(Structure):
    _fields_ = [(name, c_uint32) for name in ("visible", "triangles", "shadow_only", "parts", "parts_left_out")]


GetProcAddress = ctypes.CFUNCTYPE(c_void_p, c_void_p, c_char_p)


class RendererDef(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("get_proc_address", GetProcAddress), ("user", c_void_p),
                ("strategy", c_int), ("guard", c_int), ("colours", c_int), ("key_test", c_int),
                ("batch_triangles", c_uint32), ("linear_clean", c_int32), ("flush_triangles", c_uint32),
                ("flat_triangles", c_uint32)]


class DrawStats(Structure):
    _fields_ = [("individuals", c_uint32), ("draws", c_uint32), ("triangles", c_uint32), ("vertices", c_uint64),
                ("parts", c_uint32), ("matrices", c_uint32)]


class LevelsDef(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("targets", POINTER(c_uint32)), ("target_count", c_uint32),
                ("tolerance_px", c_float), ("metres_per_unit", c_float), ("proxy_max_triangles", c_uint32), ("quadric_only", c_uint32)]


class PrepareDef(Structure):
    _fields_ = [("struct_bytes", c_uint32), ("builtin", c_char_p), ("path", c_char_p), ("clip_count", c_uint32),
                ("options", c_void_p), ("levels", POINTER(LevelsDef)), ("max_texture_px", c_uint32),
                ("folder", c_char_p)]


# By name, as in the headers, for the layout test.
STRUCTS = {
    "clq_context_def": ContextDef, "clq_actor": ActorId, "clq_transform": Transform, "clq_play": Play,
    "clq_actor_def": ActorDef, "clq_camera": Camera, "clq_hsb_range": HsbRange, "clq_clip_info": ClipInfo,
    "clq_zone_info": ZoneInfo, "clq_template_info": TemplateInfo, "clq_mesh": Mesh, "clq_triangles": Triangles,
    "clq_drawn_actor": DrawnActor, "clq_view_stats": ViewStats, "clq_renderer_def": RendererDef, "clq_draw_stats": DrawStats,
    "clq_levels_def": LevelsDef, "clq_prepare_def": PrepareDef,
}


def _folders():
    named = os.environ.get("CLAQUE_LIBRARY_DIR")
    return [pathlib.Path(folder) for folder in named.split(os.pathsep)] if named else []


def library_paths():
    """Where libclaque and libclaque-assets are looked for: in the folders of CLAQUE_LIBRARY_DIR, then by the system."""
    found = []
    for stem in ("claque", "claque-assets"):
        here = [folder / f"lib{stem}.so" for folder in _folders() if (folder / f"lib{stem}.so").exists()]
        name = str(here[0]) if here else ctypes.util.find_library(stem)
        if not name:
            raise Error(f"lib{stem} is not there: install it, or say where it is in CLAQUE_LIBRARY_DIR")
        found.append(name)
    return found


class _Library:
    """Calls by name: clq_... that return a status raise Error unless it is OK."""

    def __init__(self):
        paths = library_paths()
        self._core = ctypes.CDLL(paths[0], mode=ctypes.RTLD_GLOBAL)
        self._assets = ctypes.CDLL(paths[1])
        self._core.clq_last_error.restype = c_char_p
        self._known = {}

    def function(self, name, restype=c_int):
        try:
            found = getattr(self._core, name)
        except AttributeError:
            found = getattr(self._assets, name)
        found.restype = restype
        return found

    def call(self, name, *arguments):
        function = self._known.get(name) or self._known.setdefault(name, self.function(name))
        status = function(*arguments)
        if status != Status.OK:
            raise Error(self._core.clq_last_error().decode("utf-8", "replace"), Status(status))


_library = None


def library():
    global _library
    if _library is None:
        _library = _Library()
    return _library


def call(name, *arguments):
    library().call(name, *arguments)
