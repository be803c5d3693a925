"""Crowds, their actors, and views of them (claque/crowd.h, view.h, drawn_actor.h)."""

from ctypes import POINTER, byref, c_double, c_float, c_size_t, c_uint8, c_uint32, c_uint64, c_void_p, string_at

import numpy

from . import abi, abi_records
from .memory import borrowed, read_only
from .owner import Owned, made

VIEW_CHANGE = numpy.dtype([("index1", "u4"), ("generation", "u4"), ("in_view", "?")], align=True)


class Actor:
    """One individual, identified by its id. After its removal calls raise Error with STALE_ID."""

    def __init__(self, crowd, identity, template):
        self.crowd, self.id, self.template = crowd, identity, template

    def play(self, clip, start_s=0.0, speed=1.0, phase_s=0.0):
        """Starts the clip of this name."""
        play = abi.Play(self.template.clip(clip), start_s, speed, phase_s)
        abi.call("clq_actor_play", self.crowd.handle, self.id, byref(play))

    def set_transform(self, position, heading_rad=0.0, scale=1.0):
        """Sets the transform of its Reference Point, rotated about y."""
        transform = abi.Transform(abi.point(position), _upright(heading_rad), scale)
        abi.call("clq_crowd_set_transforms", self.crowd.handle, byref(self.id), byref(transform), c_uint32(1))

    def set_speed(self, speed):
        """Says how fast set_transform moves it, in world units a second, so that it is posed often enough."""
        abi.call("clq_crowd_set_speeds", self.crowd.handle, byref(self.id), byref(c_float(speed)), c_uint32(1))

    def randomise_colours(self):
        """Samples its colours from its template's HSB ranges by its seed (S2 5)."""
        abi.call("clq_actor_randomise_colours", self.crowd.handle, self.id, None, 0)

    def set_colours(self, rgb):
        """Sets one colour per zone: (zones, 3), each in [0, 1]."""
        rgb = numpy.ascontiguousarray(rgb, numpy.float32)
        if rgb.ndim != 2 or rgb.shape[1] != 3:
            raise ValueError(f"colours of shape {rgb.shape}: (zones, 3) is wanted")
        abi.call("clq_actor_set_colours", self.crowd.handle, self.id, rgb.ctypes.data_as(POINTER(c_float)), len(rgb))

    def set_texture_set(self, texture_set=abi.RANDOM):
        abi.call("clq_actor_set_texture_set", self.crowd.handle, self.id, c_uint32(texture_set))

    def follow(self, track, start_s=0.0):
        """Follows a track, whose time 0 is at start_s of the crowd's clock."""
        abi.call("clq_actor_follow_track", self.crowd.handle, self.id, track.handle, c_double(start_s))

    def leave_track(self, at_s):
        """Stays where its track has it at a time."""
        abi.call("clq_actor_leave_track", self.crowd.handle, self.id, c_double(at_s))

    def remove(self):
        abi.call("clq_actor_destroy", self.crowd.handle, self.id)


def _upright(heading_rad):
    return (c_float * 4)(0, float(numpy.sin(heading_rad / 2)), 0, float(numpy.cos(heading_rad / 2)))


class Crowd(Owned):
    """The actors that are updated together. It keeps the templates of all actors ever added.

    exact_poses: all actors are posed in every update, at its very time, as labels need it."""

    _destroy = "clq_crowd_destroy"

    def __init__(self, context, definition=None, exact_poses=False):
        if exact_poses:
            definition = definition or abi_records.crowd_def()
            definition.period_near_s = definition.period_far_s = 0
        super().__init__(made("clq_crowd_create", abi.call, context.handle, definition and byref(definition)), context)
        self._views, self._scenes, self._recording = [], [], None

    def add(self, template, position=(0, 0, 0), heading_rad=0.0, scale=1.0, clip=None, start_s=0.0, speed=1.0,
            phase_s=0.0, seed=0, texture_set=0, colours=True):
        """Adds an individual. `clip`: a name, or None for the rest pose; `colours`: sampled by its seed if true, else
        the template's."""
        definition = abi.ActorDef()
        definition.tmpl = template.handle
        definition.transform = abi.Transform(abi.point(position), _upright(heading_rad), scale)
        definition.play = abi.Play(abi.NONE if clip is None else template.clip(clip), start_s, speed, phase_s)
        definition.seed, definition.texture_set = seed, texture_set
        identity = abi.ActorId()
        abi.call("clq_actor_create", self.handle, byref(definition), byref(identity))
        self._held += (template,)
        actor = Actor(self, identity, template)
        if colours:
            actor.randomise_colours()
        return actor

    def __len__(self):
        return abi.library().function("clq_crowd_get_actor_count", c_uint32)(self.handle)

    @property
    def hash(self):
        """The hash of all state that was set in the crowd."""
        return abi.library().function("clq_crowd_get_hash", c_uint64)(self.handle)

    def view(self):
        view = View(self)
        self._views.append(view)
        return view

    def update(self, time_s, *views):
        """Updates the crowd to a time for these views, or for all its views if none is given."""
        views = views or tuple(self._views)
        pointers = (c_void_p * len(views))(*[view.handle for view in views])
        abi.call("clq_crowd_update", self.handle, c_double(time_s), pointers, c_uint32(len(views)))

    def view_changes(self):
        """The actors that entered or left view in the last update: an array of index1, generation and in_view."""
        count = c_size_t()
        abi.call("clq_crowd_get_view_changes", self.handle, None, c_size_t(0), byref(count))
        out = numpy.zeros(count.value, VIEW_CHANGE)
        abi.call("clq_crowd_get_view_changes", self.handle, out.ctypes.data_as(POINTER(abi.ViewChange)), count,
                 byref(count))
        return out

    def record(self, path, key_bytes=65536):
        """Records the crowd to a file until end_record() or close(). claque.Record plays it."""
        file = open(path, "wb", buffering=0)

        def take(_, data, size):
            try:
                return 0 if file.write(string_at(data, size)) == size else 1
            except (OSError, ValueError):
                return 1

        definition = abi_records.RecordingDef(write=abi_records.Write(take), key_bytes=key_bytes)
        try:
            abi.call("clq_crowd_begin_recording", self.handle, byref(definition))
        except abi.Error:
            file.close()
            raise
        self._recording = (definition, file)

    @property
    def recording(self):
        """The clq_recording_info: how the recording goes."""
        out = abi_records.RecordingInfo()
        abi.call("clq_crowd_get_recording", self.handle, byref(out))
        return out

    def end_record(self):
        """Ends the recording. Returns its clq_recording_info; raises Error if it has failed."""
        out = abi_records.RecordingInfo()
        try:
            abi.call("clq_crowd_end_recording", self.handle, byref(out))
        finally:
            self._close_record()
        return out

    def _close_record(self):
        recording, self._recording = getattr(self, "_recording", None), None
        if recording:
            recording[1].close()

    def close(self):
        for child in getattr(self, "_views", []) + getattr(self, "_scenes", []):
            child._pointer = None  # destroyed with their crowd
        super().close()
        self._close_record()


class View(Owned):
    """A camera on a crowd, created by Crowd.view()."""

    def __init__(self, crowd):
        super().__init__(made("clq_view_create", abi.call, crowd.handle), crowd)
        self.camera = abi.Camera()  # the last one that look_at has set

    def look_at(self, eye, target, up=(0, 1, 0), fov_y_rad=1.0, aspect=4 / 3, near=0.1, far=1000.0):
        camera = self.camera = abi.Camera()
        definition = abi.LookAtDef(eye=abi.point(eye), target=abi.point(target), up=tuple(abi.point(up)),
                                   fov_y_rad=fov_y_rad, aspect=aspect, z_near=near, z_far=far)
        abi.call("clq_camera_look_at", byref(definition), byref(camera))
        abi.call("clq_view_set_camera", self.handle, byref(camera))

    def set_height(self, height_px):
        """Sets the height of the picture in pixels, which affects levels of detail."""
        abi.call("clq_view_set_height", self.handle, c_float(height_px))

    def set_tile(self, left, bottom, right, top):
        """Culls by a part of the picture, in shares of its size from the lower left corner."""
        abi.call("clq_view_set_tile", self.handle, (c_float * 4)(left, bottom, right, top))

    @property
    def hash(self):
        """The hash of the draw list with all its vertices: equal hashes draw equal pictures."""
        return abi.library().function("clq_view_get_hash", c_uint64)(self.handle)

    @property
    def stats(self):
        out = abi.ViewStats()
        abi.call("clq_view_get_stats", self.handle, byref(out))
        return out

    def __len__(self):
        return self.stats.visible

    def drawn_actor(self, index):
        """The clq_drawn_actor of one individual of the draw list."""
        out = abi.DrawnActor()
        abi.call("clq_view_get_drawn_actor", self.handle, index, byref(out))
        return out

    def model_view(self, index):
        """The model-view matrix, (4, 4), to be multiplied as m @ column."""
        return numpy.array(self.drawn_actor(index).model_view, numpy.float32).reshape(4, 4).T

    def arrays(self, index):
        """The clq_drawn_arrays of one individual of the draw list."""
        out = abi.DrawnArrays()
        abi.call("clq_view_get_arrays", self.handle, index, byref(out))
        return out

    def vertices(self, index, copy=False):
        """Skinned positions and normals, (n, 3) each, in the actor's own space, in the order of Template.mesh.

        Read-only views of the draw list's memory, valid until the next update of the crowd; `copy`: arrays of their
        own. Where the list holds no floats (packed vertices), read-only copies."""
        n = self.drawn_actor(index).vertex_count
        held = self.arrays(index)
        if held.positions and not copy:
            return borrowed(held.positions, (n, 3), self), borrowed(held.normals, (n, 3), self)
        positions, normals = numpy.empty((n, 3), numpy.float32), numpy.empty((n, 3), numpy.float32)
        abi.call("clq_view_get_vertices", self.handle, index, positions.ctypes.data_as(POINTER(c_float)),
                 normals.ctypes.data_as(POINTER(c_float)), c_uint32(n))
        return (positions, normals) if copy else (read_only(positions), read_only(normals))

    def palette(self, index, copy=False):
        """The matrix palette, (joints, 3, 4), to be multiplied as m @ column (S1 4): a view or a copy as in vertices.
        Key-poses and levels with deactivated nodes have copies."""
        joints = self.drawn_actor(index).joint_count
        columns = None if copy else borrowed(self.arrays(index).palette, (joints, 4, 3), self)
        if columns is None:
            columns = numpy.empty((joints, 4, 3), numpy.float32)
            abi.call("clq_view_get_palette", self.handle, index, columns.ctypes.data_as(POINTER(c_float)),
                     c_uint32(joints))
            columns = columns if copy else read_only(columns)
        return columns.transpose(0, 2, 1)

    def colours(self, index, copy=False):
        """The colours of its zones, (zones, 3), 8 bits, as for GL: a view or a copy as in vertices. An individual with
        its template's colours has a copy."""
        zones = self.drawn_actor(index).zone_count
        rgb = None if copy else borrowed(self.arrays(index).colours, (zones, 3), self)
        if rgb is not None:
            return rgb
        rgb = numpy.empty((zones, 3), numpy.uint8)
        abi.call("clq_view_get_colours", self.handle, index, rgb.ctypes.data_as(POINTER(c_uint8)), c_uint32(zones))
        return rgb if copy else read_only(rgb)
