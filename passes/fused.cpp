// The fused strategy: one draw per surface (S2 2.1).
#include "passes/strategies.h"

namespace claque::passes
{

void draw_fused(Canvas &canvas, const Individual &individual)
{
    for (uint32_t i = 0; i < individual.level->surfaces.size(); ++i) {
        const model::Surface &surface = individual.level->surfaces[i];
        const IndexSlice all = IndexSlices(*individual.level, surface).fused();
        if (!Canvas::any(individual, all)) continue;
        SurfaceState state = Canvas::state_of(individual, surface);
        state.colour_array = true;
        if (surface.dirty.count != 0 || individual.prepared->source->textures[surface.texture].has_holes) {
            state.alpha_function = gl::gequal;
            state.alpha_reference = individual.prepared->textures[surface.texture].fused_reference;
        }
        canvas.apply(state);
        canvas.use_slot_colours(individual, i);
        canvas.triangles(individual, all);
    }
}

}  // namespace claque::passes
