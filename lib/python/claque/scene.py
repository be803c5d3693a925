"""Queries of a crowd: individuals by place, by state and by category (claque/scene.h)."""

from ctypes import POINTER, byref, c_bool, c_double, c_uint32, c_uint64, cast

import numpy

from . import abi, abi_scene
from .owner import Owned, made

ID = numpy.dtype([("index1", "u4"), ("generation", "u4")])
HIT = numpy.dtype([("actor", ID), ("position", "f8", 3), ("distance", "f8")])


class Scene(Owned):
    """Finds the actors of a crowd. Answers are arrays of ids (dtype scene.ID) or hits (scene.HIT), in the order of the
    C API; Scene.actor gives the Actor of an id. Filters: template, texture_set, level, any_of, all_of, none_of; the
    last three are categories as bits."""

    _destroy = "clq_scene_destroy"

    def __init__(self, crowd):
        super().__init__(made("clq_scene_create", abi.call, crowd.handle), crowd)
        crowd._scenes.append(self)

    def update(self, time_s):
        """Takes over what has changed. Crowd.update does it too."""
        abi.call("clq_scene_update", self.handle, c_double(time_s))

    def set_categories(self, actors, categories):
        """Sets the categories, bits of one number, of all these actors."""
        ids = _ids(actors)
        abi.call(
            "clq_scene_set_categories",
            self.handle,
            _pointer(ids, abi.ActorId),
            c_uint32(len(ids)),
            c_uint64(categories),
        )

    def set_keys(self, actors, keys):
        """Gives actors their places in the host's own order; NaN: none."""
        ids, keys = _ids(actors), numpy.ascontiguousarray(keys, numpy.float64)
        if keys.shape != (len(ids),):
            raise ValueError(f"keys of shape {keys.shape} for {len(ids)} actors")
        abi.call(
            "clq_scene_set_keys", self.handle, _pointer(ids, abi.ActorId), _pointer(keys, c_double), c_uint32(len(ids))
        )

    def known(self, actor, time_s):
        """The clq_scene_actor of an actor."""
        out = abi_scene.SceneActor()
        abi.call("clq_scene_get_actor", self.handle, actor.id, c_double(time_s), byref(out))
        return out

    def find(self, **filters):
        """Ids by what they show and by category."""
        return self._all("clq_scene_find", ID, abi.ActorId, _filter(filters))

    def find_keys(self, low, high, **filters):
        """Ids by key, in its order."""
        return self._all("clq_scene_find_keys", ID, abi.ActorId, c_double(low), c_double(high), _filter(filters))

    def next(self, actor, back=False, **filters):
        """The id after an actor's in the order of keys, or before; None: there is none."""
        out = abi.ActorId()
        abi.call("clq_scene_find_next", self.handle, actor.id, c_bool(back), _filter(filters), byref(out))
        return (out.index1, out.generation) if out.index1 else None

    def nearest(self, time_s, point, count=1, max_distance=numpy.inf, **filters):
        """At most `count` hits, the nearest first."""
        hits, got = numpy.zeros(count, HIT), c_uint32()
        abi.call(
            "clq_scene_find_nearest",
            self.handle,
            c_double(time_s),
            abi.point(point),
            c_double(max_distance),
            _filter(filters),
            _pointer(hits, abi_scene.SceneHit),
            c_uint32(count),
            byref(got),
        )
        return hits[: got.value]

    def within(self, time_s, point, radius, **filters):
        """All hits within a distance, the nearest first."""
        return self._hits("clq_scene_find_within", time_s, abi.point(point), c_double(radius), filters=filters)

    def in_box(self, time_s, low, high, **filters):
        return self._hits("clq_scene_find_in_box", time_s, abi.point(low), abi.point(high), filters=filters)

    def in_frustum(self, time_s, camera, **filters):
        """camera: an abi.Camera."""
        return self._hits("clq_scene_find_in_frustum", time_s, byref(camera), filters=filters)

    def on_ray(self, time_s, origin, direction, max_distance=numpy.inf, **filters):
        """Hits in the order in which a ray enters their bodies."""
        ray = _ray(origin, direction, max_distance)
        return self._hits("clq_scene_find_on_ray", time_s, byref(ray), filters=filters)

    def pick(self, view, origin, direction, max_distance=numpy.inf, **filters):
        """The clq_scene_pick of the first triangle along a ray in a view's picture; None: there is none."""
        out, ray = abi_scene.ScenePick(), _ray(origin, direction, max_distance)
        abi.call("clq_scene_pick_triangle", self.handle, view.handle, byref(ray), _filter(filters), byref(out))
        return out if out.actor.index1 else None

    @property
    def stats(self):
        """The clq_scene_stats."""
        out = abi_scene.SceneStats()
        abi.call("clq_scene_get_stats", self.handle, byref(out))
        return out

    def _hits(self, name, time_s, *arguments, filters):
        return self._all(name, HIT, abi_scene.SceneHit, c_double(time_s), *arguments, _filter(filters))

    def _all(self, name, dtype, struct, *arguments):
        count, room = c_uint32(64), 0
        while count.value > room:
            room = count.value
            out = numpy.zeros(room, dtype)
            abi.call(name, self.handle, *arguments, _pointer(out, struct), c_uint32(room), byref(count))
        return out[: count.value]


def ray_of(camera, x, y):
    """Origin and direction of the ray through a point of a camera's picture; x and y from -1 to 1, right and up."""
    out = abi_scene.Ray()
    abi.call("clq_camera_get_ray", byref(camera), abi.c_float(x), abi.c_float(y), byref(out))
    return tuple(out.origin), tuple(out.direction)


def _pointer(array, struct):
    return cast(array.ctypes.data, POINTER(struct))


def _ids(actors):
    """Actors or ids as one array."""
    actors = list(actors)
    pairs = [(a.id.index1, a.id.generation) if hasattr(a, "id") else tuple(a) for a in actors]
    return numpy.array(pairs, ID)


def _ray(origin, direction, max_distance):
    return abi_scene.Ray(abi.point(origin), abi.point(direction), max_distance)


def _filter(filters):
    template = filters.pop("template", None)
    out = abi_scene.SceneFilter(texture_set=abi.NONE, level=abi.NONE)
    for name, value in filters.items():
        if name not in ("texture_set", "level", "any_of", "all_of", "none_of"):
            raise TypeError(f"there is no filter '{name}'")
        setattr(out, name, value)
    if template is not None:
        out.tmpl = template.handle
    return byref(out)
