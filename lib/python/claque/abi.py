"""The C ABI: structs in the order of the headers, and calls that raise Error.

tests/python/test_layout.py compares every struct here with the compiler's layout of the headers.
"""

import ctypes
from ctypes import (POINTER, Structure, c_bool, c_char_p, c_double, c_float, c_int, c_int8, c_int16, c_size_t, c_uint8,
                    c_uint16, c_uint32, c_uint64, c_void_p)

from .errors import Error, Status
from .heard import heard
from .places import library_paths

NONE = 0xFFFFFFFF
RANDOM = 0xFFFFFFFF
LOG_WARNING = 1


class Sized(Structure):
    """A struct that may grow: it begins with its size in bytes, as the clq_..._init functions of the headers set it."""

    def __init__(self, *arguments, **members):
        super().__init__(*arguments, **members)
        self.struct_bytes = ctypes.sizeof(self)

    def __setattr__(self, name, value):
        """ctypes would keep the last bits of a number that is too long, or below 0."""
        super().__setattr__(name, value)
        held = getattr(self, name) if isinstance(value, int) else value
        if isinstance(held, int) and not isinstance(held, bool) and held != value:
            raise ValueError(f"{name} cannot be {value}: it has {8 * getattr(type(self), name).size} bits")


class Allocator(Structure):
    _fields_ = [("user", c_void_p), ("allocate", c_void_p), ("release", c_void_p)]


LogWrite = ctypes.CFUNCTYPE(None, c_void_p, c_int, c_char_p)


class Log(Structure):
    _fields_ = [("user", c_void_p), ("write", LogWrite)]


class Tasks(Structure):
    _fields_ = [("user", c_void_p), ("run", c_void_p)]


class ContextDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("allocator", Allocator), ("log", Log), ("tasks", Tasks)]


def point(xyz):
    """Three numbers as the library takes them; ctypes would take fewer for zeros."""
    values = tuple(xyz)
    if len(values) != 3:
        raise ValueError(f"{values} has {len(values)} numbers; x, y and z are wanted")
    return (c_double * 3)(*values)


class ActorId(Structure):
    _fields_ = [("index1", c_uint32), ("generation", c_uint32)]


class ViewChange(Structure):
    _fields_ = [("actor", ActorId), ("in_view", c_bool)]


class Transform(Structure):
    _fields_ = [("position", c_double * 3), ("orientation_xyzw", c_float * 4), ("scale", c_float)]


class Play(Structure):
    _fields_ = [("clip", c_uint32), ("start_s", c_double), ("speed", c_float), ("phase_s", c_float)]


class ActorDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("tmpl", c_void_p), ("transform", Transform), ("play", Play),
                ("seed", c_uint64), ("texture_set", c_uint32)]



class Camera(Structure):
    _fields_ = [("eye", c_double * 3), ("rotation_xyzw", c_float * 4), ("projection", c_float * 16)]


class LookAtDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("eye", c_double * 3), ("target", c_double * 3), ("up", c_float * 3),
                ("fov_y_rad", c_float), ("aspect", c_float), ("z_near", c_float), ("z_far", c_float)]


class Texels(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("rgb", POINTER(c_uint8)), ("zones", POINTER(c_uint32)),
                ("capacity", c_size_t), ("width_px", c_uint32), ("height_px", c_uint32)]


class Influences(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("per_vertex", c_uint32), ("joints", POINTER(c_uint16)),
                ("weights", POINTER(c_float)), ("capacity", c_size_t)]


class HsbRange(Structure):
    _fields_ = [("hue_min_deg", c_float), ("hue_max_deg", c_float), ("saturation_min", c_float),
                ("saturation_max", c_float), ("brightness_min", c_float), ("brightness_max", c_float)]


class ClipInfo(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("name", c_char_p), ("start_s", c_float), ("duration_s", c_float),
                ("channel_count", c_uint32), ("rate_hz", c_float), ("error", c_float), ("error_rad", c_float),
                ("kept_count", c_uint32), ("bytes", c_uint64)]


class ZoneInfo(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("name", c_char_p), ("colour", c_float * 3), ("range", HsbRange),
                ("clean_count", c_uint32)]


class TemplateInfo(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("name", c_char_p)] + [(name, c_uint32) for name in (
        "node_count", "joint_count", "clip_count", "zone_count", "texture_count", "surface_count", "vertex_count",
        "fused_vertex_count", "triangle_count", "clean_count", "dirty_count", "coincident_count",
        "fused_triangle_count")] + [
            ("dirty_zone_mean", c_float), ("max_influences", c_uint32), ("sklsroot_centre", c_float * 3),
            ("sklsroot_radius", c_float), ("dof_count", c_uint32), ("level_count", c_uint32),
            ("part_count", c_uint32), ("bytes", c_uint64), ("marker_count", c_uint32),
            ("texture_set_count", c_uint32)]


class Mesh(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("vertex_count", c_uint32), ("positions", POINTER(c_float)),
                ("normals", POINTER(c_float)), ("uvs", POINTER(c_float)), ("colours", POINTER(c_uint8)),
                ("influence_count", c_uint32), ("bin_count", c_uint32), ("morph_count", c_uint32),
                ("normals_by_inverse", c_bool)]


class Triangles(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("texture", c_uint32), ("double_sided", c_bool), ("zone", c_uint32),
                ("index_count", c_uint32), ("indices", POINTER(c_uint32)), ("unlit", c_bool), ("emission", c_float * 3)]


class DrawnActor(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("actor", ActorId), ("tmpl", c_void_p), ("level", c_uint32),
                ("texture_set", c_uint32), ("model_view", c_float * 16), ("eye_distance_m", c_float),
                ("mirrored", c_bool), ("shadow_only", c_bool), ("parts", c_uint64), ("vertex_count", c_uint32),
                ("joint_count", c_uint32), ("morph_weight_count", c_uint32), ("zone_count", c_uint32)]


class DrawnArrays(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("positions", POINTER(c_float)), ("normals", POINTER(c_float)),
                ("packed_positions", POINTER(c_int16)), ("packed_normals", POINTER(c_int8)),
                ("packed_offset", c_float * 3), ("packed_step", c_float), ("palette", POINTER(c_float)),
                ("morph_weights", POINTER(c_float)), ("colours", POINTER(c_uint8))]


class ViewStats(Sized):
    _fields_ = [(name, c_uint32) for name in (
        "struct_bytes", "visible", "triangles", "shadow_only", "parts", "parts_left_out")] + [("bytes", c_uint64)]


GetProcAddress = ctypes.CFUNCTYPE(c_void_p, c_void_p, c_char_p)


class RendererDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("get_proc_address", GetProcAddress), ("user", c_void_p),
                ("strategy", c_int), ("guard", c_int), ("colours", c_int), ("key_test", c_int),
                ("batch_triangles", c_uint32), ("linear_clean", c_bool), ("flush_triangles", c_uint32),
                ("flat_triangles", c_uint32), ("close_texture_bytes", c_uint64),
                ("close_distance_m", c_float), ("close_textures_per_draw", c_uint32),
                ("multisample", c_bool), ("smooth_levels", c_bool)]


class DrawStats(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("individuals", c_uint32), ("draws", c_uint32), ("triangles", c_uint32),
                ("vertices", c_uint64), ("parts", c_uint32), ("matrices", c_uint32), ("close_individuals", c_uint32),
                ("close_textures_made", c_uint32), ("close_texture_bytes", c_uint64)]


class LevelsDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("targets", POINTER(c_uint32)), ("target_count", c_uint32),
                ("tolerance_px", c_float), ("metres_per_unit", c_float), ("proxy_max_triangles", c_uint32),
                ("quadric_only", c_bool)]


class AssetOptions(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("base_folder", c_char_p), ("hidden_nodes", POINTER(c_char_p)),
                ("hidden_node_count", c_uint32), ("memory_limit_bytes", c_uint64), ("bvh_metres_per_unit", c_double),
                ("strict", c_bool), ("turn_deg", c_double), ("height_m", c_double), ("scale", c_double),
                ("blend", c_int), ("colours", c_int)]


class ZoneMapZone(Structure):
    _fields_ = [("name", c_char_p), ("reduced", c_bool), ("range", POINTER(HsbRange))]


class ZoneMapDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("image", c_uint32), ("width_px", c_uint32), ("height_px", c_uint32),
                ("texels", POINTER(c_uint16)), ("zone_count", c_uint32), ("zones", POINTER(ZoneMapZone))]


class PrepareDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("builtin", c_char_p), ("path", c_char_p), ("clip_count", c_uint32),
                ("options", POINTER(AssetOptions)), ("levels", POINTER(LevelsDef)), ("max_texture_px", c_uint32),
                ("folder", c_char_p), ("dofs", c_void_p), ("dof_count", c_uint32),
                ("zone_maps", POINTER(POINTER(ZoneMapDef))), ("zone_map_count", c_uint32)]


# By their names in the headers, for the layout test.
STRUCTS = {
    "clq_context_def": ContextDef, "clq_actor": ActorId, "clq_view_change": ViewChange,
    "clq_transform": Transform, "clq_play": Play,
    "clq_actor_def": ActorDef, "clq_camera": Camera, "clq_look_at_def": LookAtDef, "clq_texels": Texels,
    "clq_influences": Influences, "clq_hsb_range": HsbRange, "clq_clip_info": ClipInfo,
    "clq_zone_info": ZoneInfo, "clq_template_info": TemplateInfo, "clq_mesh": Mesh, "clq_triangles": Triangles,
    "clq_drawn_actor": DrawnActor, "clq_drawn_arrays": DrawnArrays, "clq_view_stats": ViewStats,
    "clq_renderer_def": RendererDef, "clq_draw_stats": DrawStats,
    "clq_levels_def": LevelsDef, "clq_zone_map_zone": ZoneMapZone, "clq_zone_map_def": ZoneMapDef,
    "clq_prepare_def": PrepareDef, "clq_asset_options": AssetOptions,
}


def _loaded(path):
    try:
        return ctypes.CDLL(path, mode=ctypes.RTLD_GLOBAL)
    except OSError as error:
        raise Error(f"{path} cannot be loaded: {error}") from None


def _is_made(argument):
    """Whether a call writes an object there, which then gives the call's warnings (owner.py)."""
    return isinstance(getattr(argument, "_obj", None), c_void_p)


class _Library:
    """Calls functions by name. Functions that return a status raise Error unless it is OK."""

    def __init__(self):
        self._core, *self._others = map(_loaded, library_paths())
        self._core.clq_last_error.restype = c_char_p
        self._known = {}

    def function(self, name, restype=c_int):
        found = next((getattr(one, name) for one in (self._core, *self._others) if hasattr(one, name)), None)
        if not found:
            raise AttributeError(f"no library has the function {name}")
        found.restype = restype
        return found

    def call(self, name, *arguments):
        function = self._known.get(name) or self._known.setdefault(name, self.function(name))
        status = function(*arguments)
        if heard.texts and (status != Status.OK or not any(map(_is_made, arguments))):
            heard.warn()
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
