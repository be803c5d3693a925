#include "passes/strategies.h"

namespace claque::passes
{

void draw_binned(Canvas &canvas, const Individual &who)
{
    for (const model::Surface &surface : who.level->surfaces) {
        draw_clean(canvas, who, surface);
        const PreparedTexture &texture = who.prepared->textures[surface.texture];
        SurfaceState state = Canvas::state_of(who, surface);
        state.alpha_function = gl::gequal;
        for (const model::Bin &bin : surface.dirty_by_zone) {
            if (bin.range.count == 0) continue;
            const ZoneTest &test = texture.tests[bin.zone_index];
            state.alpha_reference = test.reference;
            canvas.apply(state);
            canvas.use_zone_colour(who, test);
            canvas.triangles(who, bin.range);
        }
    }
}

}  // namespace claque::passes
