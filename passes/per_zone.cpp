#include "passes/strategies.h"

namespace claque::passes
{

// Without holes in the texture nothing needs testing here: an unexpected texel is then a wrong colour, never a hole.
void draw_clean(Canvas &canvas, const Individual &who, uint32_t surface_index)
{
    const model::Surface &surface = who.level->surfaces[surface_index];
    const Stretches stretches(*who.level, surface);
    const PreparedTexture &texture = who.prepared->textures[surface.texture];
    SurfaceState state = Canvas::state_of(who, surface);
    if (who.prepared->source->textures[surface.texture].has_holes) {
        state.alpha_function = gl::gequal;
        state.alpha_reference = texture.hole_reference;
    }
    for (size_t bin = 0; bin < surface.clean.size(); ++bin) {
        if (!Canvas::any(who, stretches.clean(bin))) continue;
        canvas.apply(state);
        canvas.use_zone_colour(who, surface_index, texture.tests[surface.clean[bin].zone_index]);
        canvas.triangles(who, stretches.clean(bin));
    }
}

void draw_per_zone(Canvas &canvas, const Individual &who)
{
    for (uint32_t i = 0; i < who.level->surfaces.size(); ++i) {
        draw_clean(canvas, who, i);
        const model::Surface &surface = who.level->surfaces[i];
        const Stretch dirty = Stretches(*who.level, surface).dirty();
        if (!Canvas::any(who, dirty)) continue;
        SurfaceState state = Canvas::state_of(who, surface);
        state.alpha_function = canvas.options().key_test == KeyTest::equal ? gl::equal : gl::gequal;
        for (const ZoneTest &test : who.prepared->textures[surface.texture].tests) {
            state.alpha_reference = test.reference;
            canvas.apply(state);
            canvas.use_zone_colour(who, i, test);
            canvas.triangles(who, dirty);
        }
    }
}

void draw_parts(Canvas &canvas, const Individual &who)
{
    switch (who.prepared->strategy) {
        case Strategy::fused:
            return draw_fused(canvas, who);
        case Strategy::binned:
            return draw_binned(canvas, who);
        case Strategy::per_zone:
            return draw_per_zone(canvas, who);
    }
}

}  // namespace claque::passes
