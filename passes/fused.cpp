#include "passes/strategies.h"

namespace claque::passes
{

void draw_fused(Canvas &canvas, const Individual &who)
{
    for (uint32_t i = 0; i < who.level->surfaces.size(); ++i) {
        const model::Surface &surface = who.level->surfaces[i];
        const Stretch all = Stretches(*who.level, surface).fused();
        if (!Canvas::any(who, all)) continue;
        SurfaceState state = Canvas::state_of(who, surface);
        state.colour_array = true;
        if (surface.dirty.count != 0 || who.prepared->source->textures[surface.texture].has_holes) {
            state.alpha_function = gl::gequal;
            state.alpha_reference = who.prepared->textures[surface.texture].fused_reference;
        }
        canvas.apply(state);
        canvas.use_slot_colours(who, i);
        canvas.triangles(who, all);
    }
}

}  // namespace claque::passes
