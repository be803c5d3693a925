"""Runs of crowds that are recorded and played back (claque/record.h). Crowd.record() writes one."""

import math
from ctypes import byref, c_char_p, c_double, c_size_t, c_uint32, c_uint64, c_void_p

from . import abi, abi_records
from .crowd import Crowd
from .files import read_file
from .owner import Owned, made
from .scene import Scene
from .trajectories import Trajectories

_INSTANT_S = 1e-6  # a step is not late by the rounding of its time


class Record(Owned):
    """A record and the templates with which it is played. `templates`: one for each of template_names, in any order;
    they may be given later, to set_templates."""

    _destroy = "clq_record_destroy"

    def __init__(self, context, data, templates=()):
        data = bytes(data)
        super().__init__(
            made("clq_record_load", abi.call, context.handle, c_char_p(data), c_size_t(len(data))), context, data
        )
        if templates:
            self.set_templates(templates)

    @classmethod
    def load(cls, context, path, templates=()):
        return cls(context, read_file(path), templates)

    @property
    def info(self):
        """The clq_record_info."""
        out = abi_records.RecordInfo()
        abi.call("clq_record_get_info", self.handle, byref(out))
        return out

    @property
    def template_names(self):
        name = abi.library().function("clq_record_get_template_name", c_char_p)
        return [name(self.handle, c_uint32(i)).decode() for i in range(self.info.template_count)]

    @property
    def times_s(self):
        """The times of all steps."""
        out, times = c_double(), []
        for step in range(self.info.step_count):
            abi.call("clq_record_get_time", self.handle, c_uint64(step), byref(out))
            times.append(out.value)
        return times

    def set_templates(self, templates):
        pointers = (c_void_p * len(templates))(*[template.handle for template in templates])
        abi.call("clq_record_set_templates", self.handle, pointers, c_uint32(len(templates)))
        self._held += tuple(templates)

    def crowd(self):
        """An empty crowd like the recorded one, into which the record can be played."""
        definition = abi_records.CrowdDef()
        abi.call("clq_record_get_crowd_def", self.handle, byref(definition))
        made_one = Crowd(self._held[0], definition)
        made_one._held += self._held[2:]
        return made_one

    def play(self, crowd, time_s):
        """Makes all calls before the last step at or before a time. crowd.update(time_s) then shows that time."""
        abi.call("clq_record_play", self.handle, crowd.handle, c_double(time_s))

    def play_step(self, crowd, step):
        """The same for a step, of those in times_s."""
        abi.call("clq_record_play_step", self.handle, crowd.handle, c_uint64(step))

    def trajectories(self, rate_hz=25):
        """Where its people are, `rate_hz` times a second, as Trajectories: x to the east and y to the north, in metres
        of the recorded scene. An id is an actor's number; a later actor with that number gets one above all others.
        `claque tracks FILE.clt --out FILE.txt` writes the same."""
        shown, rows = self.info, []
        with self.crowd() as crowd:
            scene = Scene(crowd)
            for frame in range(math.ceil((shown.start_s - _INSTANT_S) * rate_hz),
                               math.floor((shown.end_s + _INSTANT_S) * rate_hz) + 1):
                self.play(crowd, frame / rate_hz + _INSTANT_S)
                scene.update(frame / rate_hz)
                hits = scene.in_box(frame / rate_hz, (-math.inf,) * 3, (math.inf,) * 3)
                rows += [(*hit["actor"], frame, hit["position"][0], -hit["position"][2]) for hit in hits]
        lines, own, later = [f"#framerate: {rate_hz:.15g}\n#ID\tframe\tx/m\ty/m\n"], {}, {}
        most = max((row[0] for row in rows), default=0)
        for number, generation, frame, x, y in rows:
            if own.setdefault(number, generation) != generation:
                number = later.setdefault((number, generation), most + 1 + len(later))
            lines.append(f"{number}\t{frame}\t{round(x, 4) + 0.0:.4f}\t{round(y, 4) + 0.0:.4f}\n")
        return Trajectories.from_bytes(self._held[0], "".join(lines).encode(), "record")

    def __len__(self):
        return self.info.step_count
