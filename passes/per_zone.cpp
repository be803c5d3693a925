#include "passes/strategies.h"

namespace claque::passes
{

// Without holes in the texture nothing needs testing here: an unexpected texel is then a wrong colour, never a hole.
void draw_clean(Canvas &canvas, const Individual &who, const model::Surface &surface)
{
    const PreparedTexture &texture = who.prepared->textures[surface.texture];
    SurfaceState state = Canvas::state_of(who, surface);
    if (who.prepared->source->textures[surface.texture].has_holes) {
        state.alpha_function = gl::gequal;
        state.alpha_reference = texture.hole_reference;
    }
    for (const model::Bin &bin : surface.clean) {
        if (bin.range.count == 0) continue;
        canvas.apply(state);
        canvas.use_zone_colour(who, texture.tests[bin.zone_index]);
        canvas.triangles(who, bin.range);
    }
}

void draw_per_zone(Canvas &canvas, const Individual &who)
{
    for (const model::Surface &surface : who.level->surfaces) {
        draw_clean(canvas, who, surface);
        if (surface.dirty.count == 0) continue;
        SurfaceState state = Canvas::state_of(who, surface);
        state.alpha_function = canvas.options().key_test == KeyTest::equal ? gl::equal : gl::gequal;
        for (const ZoneTest &test : who.prepared->textures[surface.texture].tests) {
            state.alpha_reference = test.reference;
            canvas.apply(state);
            canvas.use_zone_colour(who, test);
            canvas.triangles(who, surface.dirty);
        }
    }
}

}  // namespace claque::passes
