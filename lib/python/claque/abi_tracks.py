"""The structs of claque/track.h."""

from ctypes import CFUNCTYPE, POINTER, Structure, c_bool, c_double, c_float, c_uint32, c_uint64, c_void_p

from .abi import STRUCTS, Sized


class LegDef(Structure):
    _fields_ = [(name, c_uint32) for name in ("thigh", "shin", "foot", "toes")]


class LocomotionDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("tmpl", c_void_p), ("walk", c_uint32), ("run", c_uint32),
                ("idle_count", c_uint32), ("idles", POINTER(c_uint32)), ("legs", LegDef * 2)] + [
        (name, c_uint32) for name in ("slow_walk", "turn", "torso", "neck", "head")]


class LocomotionInfo(Sized):
    _fields_ = [("struct_bytes", c_uint32)] + [(name, c_float) for name in (
        "walk_stride", "run_stride", "walk_speed", "run_speed", "leg_length")] + [("legs", LegDef * 2)] + [
        (name, c_float) for name in ("slow_stride", "slow_speed")] + [
        (name, c_uint32) for name in ("torso", "neck", "head")]


class TrackPoint(Structure):
    _fields_ = [("time_s", c_double), ("position", c_double * 3), ("heading_rad", c_float)]


class TrackPassing(Structure):
    _fields_ = [("time_s", c_double), ("position", c_double * 3)]


class FoundPassing(Structure):
    _fields_ = [("track", c_uint32), ("passing", TrackPassing)]


# Of a point of the world, three doubles.
HeightFunction = CFUNCTYPE(c_double, c_void_p, POINTER(c_double))


class TrackDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("point_count", c_uint32), ("points", c_void_p), ("smooth_s", c_float),
                ("metres_per_unit", c_float), ("scale", c_float), ("seed", c_uint64), ("previous", c_void_p),
                ("end_s", c_double), ("passing_count", c_uint32), ("passings", c_void_p), ("ground", HeightFunction),
                ("ground_user", c_void_p)]


class TrackInfo(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("sample_count", c_uint32)] + [(name, c_double) for name in (
        "start_s", "end_s", "rate_hz", "distance_m", "standing_s", "mean_shift_m", "max_shift_m")] + [
        ("plant_count", c_uint32), ("bytes", c_uint64), ("hash", c_uint64), ("previous_hash", c_uint64)]


class TrackState(Structure):
    _fields_ = [("present", c_bool), ("stands", c_bool), ("position", c_double * 3), ("heading_rad", c_double),
                ("phase", c_double), ("gait", c_float), ("speed_m_s", c_float)]


STRUCTS.update({
    "clq_leg_def": LegDef, "clq_locomotion_def": LocomotionDef, "clq_locomotion_info": LocomotionInfo,
    "clq_track_point": TrackPoint, "clq_track_passing": TrackPassing, "clq_found_passing": FoundPassing,
    "clq_track_def": TrackDef, "clq_track_info": TrackInfo, "clq_track_state": TrackState,
})
