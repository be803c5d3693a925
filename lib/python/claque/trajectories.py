"""Where people walked and where they can walk (claque/trajectories.h), with NumPy views."""

from ctypes import POINTER, byref, c_double, c_size_t, c_uint8, c_uint32, cast

import numpy

from . import abi, abi_trajectories
from .memory import borrowed
from .owner import Owned, made

SAMPLE = numpy.dtype([("time_s", "f8"), ("x", "f8"), ("y", "f8"), ("z", "f8"), ("heading_rad", "f4"), ("flags", "u4")])


class Trajectories(Owned):
    """The people of a file. `options` are the members of clq_trajectories_def: rate_hz, metres_per_unit,
    columns, ..."""

    _destroy = "clq_trajectories_destroy"

    @classmethod
    def load(cls, context, path, **options):
        return cls(
            made("clq_trajectories_load", abi.call, context.handle, str(path).encode(), cls._def(options)), context
        )

    @classmethod
    def from_bytes(cls, context, data, name="", **options):
        return cls(
            made(
                "clq_trajectories_load_memory",
                abi.call,
                context.handle,
                data,
                c_size_t(len(data)),
                name.encode(),
                cls._def(options),
            ),
            context,
        )

    @staticmethod
    def _def(options):
        definition = abi_trajectories.TrajectoriesDef(max_speed_m_s=12, start_s=-numpy.inf, end_s=numpy.inf)
        for name, value in options.items():
            if name not in dict(abi_trajectories.TrajectoriesDef._fields_):
                raise TypeError(f"clq_trajectories_def has no member {name}")
            if name == "picture_to_metres":
                value = (c_double * 9)(*numpy.asarray(value, float).reshape(9))
                value = cast(value, POINTER(c_double))
            setattr(definition, name, value.encode() if isinstance(value, str) else value)
        return byref(definition)

    @property
    def info(self):
        """The clq_trajectories_info."""
        out = abi_trajectories.TrajectoriesInfo()
        abi.call("clq_trajectories_get_info", self.handle, byref(out))
        return out

    @property
    def samples(self):
        """All samples, sorted by person and time: a read-only array of the type SAMPLE, not a copy."""
        first = abi.library().function("clq_trajectories_get_samples", POINTER(c_uint8))(self.handle)
        return borrowed(first, (SAMPLE.itemsize * self.info.sample_count,), self).view(SAMPLE)

    @property
    def people(self):
        """(id, samples) of each person; the arrays are parts of `samples`."""
        samples, out = self.samples, []
        for i in range(self.info.person_count):
            person = abi_trajectories.TrajectoryPerson()
            abi.call("clq_trajectories_get_person", self.handle, c_uint32(i), byref(person))
            out.append((person.id.decode(), samples[person.first_sample : person.first_sample + person.sample_count]))
        return out

    @property
    def warnings(self):
        return _warnings("clq_trajectories_get_warning", self)


class Area(Owned):
    """A walkable area: `points`, three coordinates each; `triangles` and `walls`, indices of points."""

    _destroy = "clq_area_destroy"

    @classmethod
    def load(cls, context, path):
        return cls(made("clq_area_load", abi.call, context.handle, str(path).encode()), context)

    @classmethod
    def from_bytes(cls, context, data, name=""):
        return cls(
            made("clq_area_load_memory", abi.call, context.handle, data, c_size_t(len(data)), name.encode()), context
        )

    @property
    def info(self):
        """The clq_area_info."""
        out = abi_trajectories.AreaInfo()
        abi.call("clq_area_get_info", self.handle, byref(out))
        return out

    @property
    def points(self):
        return borrowed(self.info.points_m, (self.info.point_count, 3), self)

    @property
    def triangles(self):
        return borrowed(self.info.triangles, (self.info.triangle_count, 3), self)

    @property
    def walls(self):
        return borrowed(self.info.walls, (self.info.wall_count, 2), self)

    @property
    def warnings(self):
        return _warnings("clq_area_get_warning", self)


def _warnings(name, owner):
    text = abi.library().function(name, abi.c_char_p)
    return [text(owner.handle, c_uint32(i)).decode() for i in range(owner.info.warning_count)]
