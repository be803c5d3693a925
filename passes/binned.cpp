#include "passes/strategies.h"

namespace claque::passes
{

void draw_binned(Canvas &canvas, const Individual &who)
{
    for (uint32_t i = 0; i < who.level->surfaces.size(); ++i) {
        draw_clean(canvas, who, i);
        const model::Surface &surface = who.level->surfaces[i];
        const Stretches stretches(*who.level, surface);
        const PreparedTexture &texture = who.prepared->textures[surface.texture];
        SurfaceState state = Canvas::state_of(who, surface);
        state.alpha_function = gl::gequal;
        for (size_t bin = 0; bin < surface.dirty_by_zone.size(); ++bin) {
            if (!Canvas::any(who, stretches.by_zone(bin))) continue;
            const ZoneTest &test = texture.tests[surface.dirty_by_zone[bin].zone_index];
            state.alpha_reference = test.reference;
            canvas.apply(state);
            canvas.use_zone_colour(who, i, test);
            canvas.triangles(who, stretches.by_zone(bin));
        }
    }
}

}  // namespace claque::passes
