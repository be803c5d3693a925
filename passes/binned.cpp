// The binned strategy: a dirty triangle is drawn in the passes of the zones that it touches (S1 3).
#include "passes/strategies.h"

namespace claque::passes
{

void draw_binned(Canvas &canvas, const Individual &individual)
{
    for (uint32_t i = 0; i < individual.level->surfaces.size(); ++i) {
        draw_clean(canvas, individual, i);
        const model::Surface &surface = individual.level->surfaces[i];
        const IndexSlices slices(*individual.level, surface);
        const PreparedTexture &texture = individual.prepared->textures[surface.texture];
        SurfaceState state = Canvas::state_of(individual, surface);
        state.alpha_function = gl::gequal;
        for (size_t bin = 0; bin < surface.dirty_by_zone.size(); ++bin) {
            if (!Canvas::any(individual, slices.by_zone(bin))) continue;
            const ZoneTest &test = texture.tests[surface.dirty_by_zone[bin].zone_index];
            state.alpha_reference = test.reference;
            canvas.apply(state);
            canvas.use_zone_colour(individual, i, test);
            canvas.triangles(individual, slices.by_zone(bin));
        }
    }
}

}  // namespace claque::passes
