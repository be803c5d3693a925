"""The structs of claque/record.h, and the definition of a crowd (claque/crowd.h)."""

import ctypes
from ctypes import Structure, c_bool, c_char, c_double, c_float, c_int, c_size_t, c_uint32, c_uint64, c_void_p

from .abi import STRUCTS, Sized

Write = ctypes.CFUNCTYPE(c_int, c_void_p, c_void_p, c_size_t)


class KeyPoseBand(Structure):
    _fields_ = [("distance_min_m", c_float), ("mode", c_int)]


class KeyPoses(Structure):
    _fields_ = [("bands", KeyPoseBand * 4), ("band_count", c_uint32), ("rate_hz", c_float), ("max_kept", c_uint32),
                ("budget_bytes", c_uint64)]


class CrowdDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("cache", c_int), ("cache_budget_bytes", c_uint64),
                ("period_near_s", c_float), ("period_far_s", c_float), ("distance_near_m", c_float),
                ("distance_far_m", c_float), ("metres_per_unit", c_float), ("seed", c_uint64), ("cull", c_int),
                ("rigid_mode", c_int), ("lod_scale", c_float), ("lod_hysteresis", c_float), ("vertex_format", c_int),
                ("clock", c_int), ("update_budget", c_uint32), ("update_budget_ms", c_float), ("now_s", c_void_p),
                ("now_user", c_void_p), ("key_poses", KeyPoses), ("motion_tolerance_px", c_float)]


def crowd_def():
    """As clq_crowd_def_init returns it."""
    return CrowdDef(period_near_s=0.02, period_far_s=0.25, distance_near_m=5, distance_far_m=50, metres_per_unit=1,
                    lod_scale=1, key_poses=KeyPoses(rate_hz=15, max_kept=256), motion_tolerance_px=1)


class RecordingDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("write", Write), ("user", c_void_p), ("key_bytes", c_uint64)]


class RecordingInfo(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("status", c_int), ("text", c_char * 240), ("bytes", c_uint64),
                ("calls", c_uint64), ("steps", c_uint64), ("tracks", c_uint64), ("key_states", c_uint64),
                ("held_bytes", c_uint64)]


class RecordInfo(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("whole", c_bool), ("template_count", c_uint32), ("track_count", c_uint32),
                ("step_count", c_uint64), ("call_count", c_uint64), ("state_count", c_uint64), ("start_s", c_double),
                ("end_s", c_double), ("bytes", c_uint64), ("read_bytes", c_uint64)]


STRUCTS.update({
    "clq_key_pose_band": KeyPoseBand, "clq_key_poses": KeyPoses, "clq_crowd_def": CrowdDef,
    "clq_recording_def": RecordingDef, "clq_recording_info": RecordingInfo, "clq_record_info": RecordInfo,
})
