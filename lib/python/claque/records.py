"""Runs of crowds that are recorded and played back (claque/record.h). Crowd.record() writes one."""

from ctypes import byref, c_char_p, c_double, c_size_t, c_uint32, c_uint64, c_void_p

from . import abi, abi_records
from .crowd import Crowd
from .files import read_file
from .owner import Owned, made


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

    def __len__(self):
        return self.info.step_count
