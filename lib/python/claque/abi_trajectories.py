"""The structs of claque/trajectories.h."""

from ctypes import POINTER, Structure, c_bool, c_char_p, c_double, c_float, c_int, c_uint32, c_uint64

from .abi import STRUCTS, Sized


class TrajectoriesDef(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("format", c_int), ("columns", c_char_p), ("rate_hz", c_double),
                ("metres_per_unit", c_double), ("up", c_int), ("vehicles", c_bool),
                ("picture_to_metres", POINTER(c_double)), ("max_speed_m_s", c_double), ("max_gap_s", c_double),
                ("start_s", c_double), ("end_s", c_double), ("memory_limit_bytes", c_uint64)]


class TrajectoriesInfo(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("format", c_int), ("person_count", c_uint32), ("id_count", c_uint32),
                ("sample_count", c_uint64), ("row_count", c_uint64), ("min_s", c_double), ("max_s", c_double),
                ("step_s", c_double), ("box_min_m", c_double * 3), ("box_max_m", c_double * 3),
                ("most_at_once", c_uint32), ("most_at_once_s", c_double), ("has_headings", c_bool),
                ("warning_count", c_uint32)]


class TrajectoryPerson(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("id", c_char_p), ("first_sample", c_uint64), ("sample_count", c_uint64),
                ("height_m", c_float)]


class AreaRing(Structure):
    _fields_ = [("polygon", c_uint32), ("first_point", c_uint32), ("point_count", c_uint32), ("hole", c_bool)]


class AreaInfo(Sized):
    _fields_ = [("struct_bytes", c_uint32), ("polygon_count", c_uint32), ("ring_count", c_uint32),
                ("point_count", c_uint32), ("triangle_count", c_uint32), ("wall_count", c_uint32),
                ("warning_count", c_uint32), ("rings", POINTER(AreaRing)), ("points_m", POINTER(c_double)),
                ("triangles", POINTER(c_uint32)), ("walls", POINTER(c_uint32)), ("area_m2", c_double),
                ("box_min_m", c_double * 3), ("box_max_m", c_double * 3)]


STRUCTS.update({
    "clq_trajectories_def": TrajectoriesDef, "clq_trajectories_info": TrajectoriesInfo,
    "clq_trajectory_person": TrajectoryPerson, "clq_area_ring": AreaRing, "clq_area_info": AreaInfo,
})
