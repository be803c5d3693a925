"""The structs of claque/scene.h."""

from ctypes import Structure, c_bool, c_double, c_float, c_uint32, c_uint64, c_void_p

from .abi import STRUCTS, ActorId, Sized


class SceneFilter(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("tmpl", c_void_p), ("texture_set", c_uint32), ("level", c_uint32),
                ("any_of", c_uint64), ("all_of", c_uint64), ("none_of", c_uint64)]


class SceneActor(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("present", c_bool), ("position", c_double * 3), ("centre", c_double * 3),
                ("radius", c_double), ("tmpl", c_void_p), ("texture_set", c_uint32), ("level", c_uint32),
                ("categories", c_uint64), ("key", c_double)]


class SceneHit(Structure):
    _fields_ = [("actor", ActorId), ("position", c_double * 3), ("distance", c_double)]


class Ray(Structure):
    _fields_ = [("origin", c_double * 3), ("direction", c_double * 3), ("max_distance", c_double)]


class ScenePick(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("actor", ActorId), ("index", c_uint32), ("part", c_uint32),
                ("zone", c_uint32), ("vertices", c_uint32 * 3), ("barycentric", c_float * 3), ("distance", c_double),
                ("position", c_double * 3)]


class SceneStats(Sized):
    _fields_ = [(name, c_uint32) for name in ("struct_bytes", "actor_count", "marked", "moving", "keyed", "height")] + [
        ("placed", c_uint64), ("bytes", c_uint64)]


STRUCTS.update({
    "clq_scene_filter": SceneFilter, "clq_scene_actor": SceneActor, "clq_scene_hit": SceneHit, "clq_ray": Ray,
    "clq_scene_pick": ScenePick, "clq_scene_stats": SceneStats,
})
