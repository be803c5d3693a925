"""Exact labels of pictures as NumPy arrays (claque/visibility.h), without files."""

from ctypes import POINTER, byref, c_double, c_float, c_uint32, c_uint64

import numpy

from . import abi, abi_labels

# Member of clq_pixel_channels: type, numbers a pixel.
_CHANNELS = {"individuals": (numpy.uint32, 1), "actors": (numpy.uint32, 1), "parts": (numpy.uint32, 1),
             "zones": (numpy.uint32, 1), "triangles": (numpy.uint32, 1), "barycentric": (numpy.float32, 3),
             "depth_m": (numpy.float32, 1), "positions": (numpy.float64, 3), "normals": (numpy.float32, 3)}
_POINTERS = {numpy.uint32: c_uint32, numpy.float32: c_float, numpy.float64: c_double}


class Sample:
    """One labelled picture; all arrays are (height, width) or (height, width, n), top row first.

    time_s; picture: RGB; actors: index1 of the actor, 0 where there is none; individuals: of the view's draw list;
    parts, zones, triangles: claque.abi.NONE where there is none; barycentric; depth_m, positions (in the world),
    normals: NaN where there is none; forward, backward: optical flow in pixels to the right and down."""

    def __init__(self, time_s, picture):
        self.time_s, self.picture = time_s, picture


def labels(crowd, view, renderer, target, times, step_s=None, look=None, place=None, scenery=None):
    """Yields a Sample for each time.

    crowd      made with exact_poses, so that poses are those of the very times
    renderer   prepared for all templates; target: the Offscreen that it draws to
    step_s     of optical flow to the times before and after; None: no flow
    look       called as look(view, time_s), to set the camera; None: the camera stays
    place      called as place(time_s), to move and play actors by hand; None: the crowd does all by itself
    scenery    called as scenery(target, time_s), to draw what hides people; its pixels have no labels"""
    look, place, scenery = look or (lambda *_: None), place or (lambda *_: None), scenery or (lambda *_: None)
    for time_s in times:
        place(time_s)
        look(view, time_s)
        crowd.update(time_s, view)
        target.clear()
        scenery(target, time_s)
        renderer.draw(view)
        sample = Sample(time_s, target.picture().copy())
        numbers = _numbers(view, renderer, target, lambda: scenery(target, time_s))
        _add_channels(sample, view, numbers)
        if step_s is not None:
            for name, other_s in (("forward", time_s + step_s), ("backward", time_s - step_s)):
                place(other_s)
                look(view, other_s)
                setattr(sample, name, _flow(view, numbers, other_s))
        yield sample


def _numbers(view, renderer, target, scenery):
    """The visibility picture, bottom row first. Scenery fills the depth buffer alone."""
    count = c_uint64()
    abi.call("clq_view_get_triangle_count", view.handle, byref(count))
    out = numpy.zeros((target.height, target.width), numpy.uint32)
    for shift in (0, 24) if count.value >= 1 << 24 else (0,):
        target.clear()
        target.gl("glClearColor", 0.0, 0.0, 0.0, 0.0)
        target.gl("glClear", 0x4000)
        target.gl("glColorMask", 0, 0, 0, 0)
        scenery()
        target.gl("glColorMask", 1, 1, 1, 1)
        definition = abi_labels.VisibilityDef(first_number=1, upper_bits=shift > 0)
        abi.call("clq_renderer_draw_visibility", renderer.handle, view.handle, byref(definition), None)
        rgb = target.pixels[:, :, :3].astype(numpy.uint32)
        out |= (rgb[:, :, 0] | rgb[:, :, 1] << 8 | rgb[:, :, 2] << 16) << shift
    return out


def _pixels(numbers):
    return abi_labels.Pixels(width_px=numbers.shape[1], height_px=numbers.shape[0], first_number=1,
                             numbers=numbers.ctypes.data_as(POINTER(c_uint32)))


def _add_channels(sample, view, numbers):
    channels, arrays = abi_labels.PixelChannels(), {}
    for name, (kind, per_pixel) in _CHANNELS.items():
        arrays[name] = numpy.empty(numbers.shape + ((per_pixel,) if per_pixel > 1 else ()), kind)
        setattr(channels, name, arrays[name].ctypes.data_as(POINTER(_POINTERS[kind])))
    abi.call("clq_view_get_pixels", view.handle, byref(_pixels(numbers)), byref(channels))
    for name, array in arrays.items():
        setattr(sample, name, array[::-1].copy())


def _flow(view, numbers, time_s):
    out = numpy.empty(numbers.shape + (2,), numpy.float32)
    definition = abi_labels.FlowDef(time_s=time_s, camera=view.camera)
    abi.call("clq_view_get_flow", view.handle, byref(_pixels(numbers)), byref(definition),
             out.ctypes.data_as(POINTER(c_float)))
    out = out[::-1].copy()
    out[:, :, 1] *= -1
    return out
