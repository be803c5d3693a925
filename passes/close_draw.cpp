// Draws an individual with textures of its own: no zones, no dirty triangles.
#include "passes/strategies.h"

namespace claque::passes
{

void draw_close(Canvas &canvas, const Individual &individual)
{
    const Array<model::Surface> &surfaces = individual.item->tmpl->levels[individual.item->level].surfaces;
    for (uint32_t i = 0; i < surfaces.size(); ++i) {
        SurfaceState state;
        state.texture = individual.close[i];
        state.double_sided = surfaces[i].double_sided;
        state.lighting = surfaces[i].lighting;
        state.mirrored = individual.item->mirrored;
        state.colour_array = !individual.level->colours.empty();
        if (individual.prepared->source->textures[surfaces[i].texture].has_holes)
            state.alpha_function = gl::gequal, state.alpha_reference = 0.5f;
        canvas.apply(state);
        if (i == 0) canvas.use_own_colours(individual);  // alike for all surfaces
        canvas.plain_triangles(individual, i);
    }
}

}  // namespace claque::passes
