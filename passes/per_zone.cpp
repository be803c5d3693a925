// The per-zone strategy: dirty triangles are drawn once for every zone (S1 3).
#include "passes/strategies.h"

namespace claque::passes
{

// Without holes in the texture no alpha test is needed; an unexpected texel then gives a wrong colour, never a hole.
void draw_clean(Canvas &canvas, const Individual &individual, uint32_t surface_index)
{
    const model::Surface &surface = individual.level->surfaces[surface_index];
    const IndexSlices slices(*individual.level, surface);
    const PreparedTexture &texture = individual.prepared->textures[surface.texture];
    SurfaceState state = Canvas::state_of(individual, surface);
    if (individual.prepared->source->textures[surface.texture].has_holes) {
        state.alpha_function = gl::gequal;
        state.alpha_reference = texture.hole_reference;
    }
    for (size_t bin = 0; bin < surface.clean.size(); ++bin) {
        if (!Canvas::any(individual, slices.clean(bin))) continue;
        canvas.apply(state);
        canvas.use_zone_colour(individual, surface_index, texture.tests[surface.clean[bin].zone_index]);
        canvas.triangles(individual, slices.clean(bin));
    }
}

void draw_per_zone(Canvas &canvas, const Individual &individual)
{
    for (uint32_t i = 0; i < individual.level->surfaces.size(); ++i) {
        draw_clean(canvas, individual, i);
        const model::Surface &surface = individual.level->surfaces[i];
        const IndexSlice dirty = IndexSlices(*individual.level, surface).dirty();
        if (!Canvas::any(individual, dirty)) continue;
        SurfaceState state = Canvas::state_of(individual, surface);
        state.alpha_function = canvas.options().key_test == KeyTest::equal ? gl::equal : gl::gequal;
        for (const ZoneTest &test : individual.prepared->textures[surface.texture].tests) {
            state.alpha_reference = test.reference;
            canvas.apply(state);
            canvas.use_zone_colour(individual, i, test);
            canvas.triangles(individual, dirty);
        }
    }
}

void draw_parts(Canvas &canvas, const Individual &individual)
{
    if (individual.close) return draw_close(canvas, individual);
    if (individual.one_colour) return draw_plain(canvas, individual);
    switch (individual.prepared->strategy) {
        case Strategy::fused:
            return draw_fused(canvas, individual);
        case Strategy::binned:
            return draw_binned(canvas, individual);
        case Strategy::per_zone:
            return draw_per_zone(canvas, individual);
    }
}

}  // namespace claque::passes
