"""Draws draw lists in the current GL context (claque/renderer.h)."""

from ctypes import byref

from . import abi
from .owner import Owned, made

STRATEGIES = {"fused": 0, "binned": 1, "per-zone": 2}


class Renderer(Owned):
    """A renderer for the current context. `target`: an Offscreen or another object with `get_proc_address`
    (an abi.GetProcAddress)."""

    _destroy = "clq_renderer_destroy"

    def __init__(self, context, target, strategy="fused", linear_clean=False, flush_triangles=0,
                 flat_triangles=64, close_texture_bytes=0, close_distance_m=0,
                 close_textures_per_draw=0, multisample=False, smooth_levels=False):
        if strategy not in STRATEGIES:
            raise ValueError(f"{strategy!r} is none of {', '.join(STRATEGIES)}")
        definition = abi.RendererDef()
        definition.get_proc_address = target.get_proc_address
        definition.strategy = STRATEGIES[strategy]
        definition.batch_triangles = 128
        definition.linear_clean = bool(linear_clean)
        definition.flush_triangles = flush_triangles
        definition.flat_triangles = flat_triangles
        definition.close_texture_bytes = close_texture_bytes
        definition.close_distance_m = close_distance_m
        definition.close_textures_per_draw = close_textures_per_draw
        definition.multisample, definition.smooth_levels = bool(multisample), bool(smooth_levels)
        super().__init__(made("clq_renderer_create", abi.call, context.handle, byref(definition)), context, target)

    def prepare(self, *templates):
        """Uploads the textures of templates to GL; to be called once, before the first draw that shows them."""
        for template in templates:
            abi.call("clq_renderer_prepare", self.handle, template.handle)
            self._held += (template,)

    def draw(self, view):
        """Draws the draw list that the last update made for a view; returns clq_draw_stats."""
        stats = abi.DrawStats()
        abi.call("clq_renderer_draw", self.handle, view.handle, byref(stats))
        return stats
