"""People who walk where arrays say that they were (claque/track.h)."""

import math
from ctypes import POINTER, byref, c_double, c_size_t, c_uint32, cast

import numpy

from . import abi, abi_tracks
from .owner import Owned, made

POINT = numpy.dtype([("time_s", "f8"), ("position", "f8", 3), ("heading_rad", "f4")], align=True)
PASSING = numpy.dtype([("time_s", "f8"), ("position", "f8", 3)], align=True)
FOUND = numpy.dtype([("track", "u4"), ("passing", PASSING)], align=True)


class Locomotion(Owned):
    """The clips that a template stands, walks and runs with, by name; measured once.

    legs: names of thigh, shin and foot, or of toes too, of the left and the right leg, where they have no usual names;
    torso, neck and head: names of these nodes, likewise."""

    _destroy = "clq_locomotion_destroy"

    def __init__(self, template, walk="walk", run=None, idles=(), slow_walk=None, turn=None, legs=((), ()), torso=None,
                 neck=None, head=None):
        def number(name):
            return abi.NONE if name is None else template.clip(name)

        def node(name):
            return abi.NONE if name is None else template.node(name)

        definition = abi_tracks.LocomotionDef(tmpl=template.handle, walk=template.clip(walk), run=number(run),
                                       slow_walk=number(slow_walk), turn=number(turn), torso=node(torso),
                                       neck=node(neck), head=node(head))
        idles = (c_uint32 * len(idles))(*[template.clip(name) for name in idles])
        definition.idle_count, definition.idles = len(idles), cast(idles, POINTER(c_uint32))
        for leg, names in zip(definition.legs, legs):
            leg.thigh, leg.shin, leg.foot, leg.toes = (*map(node, names), *4 * [abi.NONE])[:4]
        context = template._held[0]
        super().__init__(made("clq_locomotion_create", abi.call, context.handle, byref(definition)), template)
        self.template = template

    @property
    def info(self):
        """The clq_locomotion_info."""
        out = abi_tracks.LocomotionInfo()
        abi.call("clq_locomotion_get_info", self.handle, byref(out))
        return out


def _definition(times_s, points, headings=None, **options):
    """A clq_track_def, and the array that it points into."""
    times_s, points = numpy.asarray(times_s, float), numpy.asarray(points, float)
    if times_s.ndim != 1 or points.shape != (len(times_s), 3):
        raise ValueError(f"times of shape {times_s.shape} and points of shape {points.shape}: (n,) and (n, 3) are "
                         "wanted")
    own = numpy.zeros(len(times_s), POINT)
    own["time_s"], own["position"] = times_s, points
    own["heading_rad"] = numpy.nan if headings is None else headings
    return abi_tracks.TrackDef(point_count=len(own), points=own.ctypes.data, **options), own


def find_passings(context, people, metres_per_unit=1.0):
    """Finds where people come within 1 m of each other while they move against each other (clq_find_passings).

    people: one (times_s, points) for each, as for Track. Returns an array of times and positions of the others for
    each, as Track takes it."""
    made_ones = [_definition(times_s, points, metres_per_unit=metres_per_unit) for times_s, points in people]
    definitions = (POINTER(abi_tracks.TrackDef) * len(made_ones))(*[cast(byref(one), POINTER(abi_tracks.TrackDef))
                                                                   for one, _ in made_ones])
    count = c_size_t()
    arguments = context.handle, definitions, c_uint32(len(made_ones))
    abi.call("clq_find_passings", *arguments, None, c_size_t(0), byref(count))
    found = numpy.zeros(count.value, FOUND)
    abi.call("clq_find_passings", *arguments, found.ctypes.data_as(POINTER(abi_tracks.FoundPassing)), count,
             byref(count))
    return [found["passing"][found["track"] == number] for number in range(len(made_ones))]


def _height(ground, point, failed):
    """The height of the ground at a point; an exception is kept for the caller, for it cannot pass through C."""
    try:
        return math.nan if failed else float(ground(point[0], point[1], point[2]))
    except Exception as error:
        failed.append(error)
        return math.nan


class Track(Owned):
    """The path of one actor.

    points: (n, 3), y up, in world units; headings: radians about y, NaN where unknown; previous: the piece that this
    one continues; end_s: where it ends before the last point; passings: others that pass, from find_passings; ground: a
    function of x, y, z that gives the height of the ground there, or NaN, as clq_track_def.ground."""

    _destroy = "clq_track_destroy"

    def __init__(self, locomotion, times_s, points, headings=None, smooth_s=1.1, metres_per_unit=1.0, scale=1.0, seed=0,
                 previous=None, end_s=1e300, passings=None, ground=None):
        passings = numpy.ascontiguousarray(numpy.zeros(0) if passings is None else passings, PASSING)
        definition, own = _definition(times_s, points, headings, smooth_s=smooth_s, metres_per_unit=metres_per_unit,
                                      scale=scale, seed=seed, previous=previous.handle if previous else None,
                                      end_s=end_s, passing_count=len(passings), passings=passings.ctypes.data)
        failed = []
        if ground:
            definition.ground = abi_tracks.HeightFunction(lambda _, point: _height(ground, point, failed))
        super().__init__(made("clq_track_create", abi.call, locomotion.handle, byref(definition)), locomotion)
        if failed:
            raise failed[0]
        del own, passings  # claque has copied them

    @property
    def info(self):
        """The clq_track_info."""
        out = abi_tracks.TrackInfo()
        abi.call("clq_track_get_info", self.handle, byref(out))
        return out

    def at(self, time_s):
        """The clq_track_state at a time."""
        out = abi_tracks.TrackState()
        abi.call("clq_track_evaluate", self.handle, c_double(time_s), byref(out))
        return out


class Tracks:
    """One track for each person of arrays with one row a sample: `ids` and `tracks`, in the order of first rows."""

    def __init__(self, ids, tracks):
        self.ids, self.tracks = list(ids), list(tracks)

    @classmethod
    def from_numpy(cls, locomotion, ids, times_s, xy, headings=None, passings=True, **options):
        """xy: (n, 2), metres to the east and north, or (n, 3) with the height; headings: radians counter-clockwise from
        the east. In the crowd x is east, y up, and z south. Rows may stand in any order. passings: whether people turn
        their shoulders where they pass closely. `options`: as for Track."""
        ids, times_s, xy = numpy.asarray(ids), numpy.asarray(times_s, float), numpy.asarray(xy, float)
        good = ids.shape == times_s.shape and ids.ndim == 1 and xy.ndim == 2
        if not good or len(xy) != len(ids) or xy.shape[1] not in (2, 3):
            raise ValueError(f"ids, times and positions of shapes {ids.shape}, {times_s.shape} and {xy.shape}: (n,), "
                             "(n,) and (n, 2) or (n, 3) are wanted")
        points = numpy.zeros((len(ids), 3))
        points[:, 0], points[:, 2] = xy[:, 0], -xy[:, 1]
        if xy.shape[1] == 3:
            points[:, 1] = xy[:, 2]
        if headings is not None:
            headings = numpy.asarray(headings, float) + numpy.pi / 2
        order = numpy.argsort(times_s, kind="stable")
        names, first = numpy.unique(ids, return_index=True)
        names = names[numpy.argsort(first)]
        rows = [order[ids[order] == name] for name in names]
        near = [None] * len(names)
        if passings:
            near = find_passings(locomotion.template._held[0], [(times_s[own], points[own]) for own in rows],
                                 options.get("metres_per_unit", 1.0))
        tracks = [Track(locomotion, times_s[own], points[own], None if headings is None else headings[own],
                        **{"seed": number, "passings": near[number], **options}) for number, own in enumerate(rows)]
        return cls(names.tolist(), tracks)

    @classmethod
    def from_trajectories(cls, locomotion, trajectories, **options):
        """Of the people of claque.Trajectories."""
        samples = trajectories.samples
        names = numpy.concatenate([numpy.full(len(own), i) for i, (_, own) in enumerate(trajectories.people)])
        xyz = numpy.stack([samples["x"], samples["y"], samples["z"]], axis=1)
        made_ones = cls.from_numpy(locomotion, names, samples["time_s"], xyz, samples["heading_rad"], **options)
        made_ones.ids = [name for name, _ in trajectories.people]
        return made_ones

    def __len__(self):
        return len(self.tracks)

    def enter(self, crowd, start_s=0.0, **options):
        """Adds an actor to a crowd for each track, which it follows; `options` as for Crowd.add. Returns the actors."""
        actors = []
        for number, track in enumerate(self.tracks):
            actor = crowd.add(track._held[0].template, seed=number, **options)
            actor.follow(track, start_s)
            actors.append(actor)
        return actors
