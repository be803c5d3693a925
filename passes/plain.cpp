#include "passes/plain.h"

#include <cstring>

#include "passes/parts.h"
#include "passes/strategies.h"

namespace claque::passes
{

void prepare_plain(PreparedLevel &out, const model::Level &level)
{
    if (out.batched) return;
    PlainLevel &plain = out.plain;
    Array<uint32_t> indices(plain.indices.get_allocator());
    for (const model::Surface &surface : level.surfaces) {
        const uint32_t first = static_cast<uint32_t>(indices.size());
        const auto add = [&](model::IndexRange share) {
            const auto from = level.indices.begin() + std::ptrdiff_t(share.first);
            indices.insert(indices.end(), from, from + std::ptrdiff_t(share.count));
        };
        const IndexSlices slices(level, surface);
        for (uint32_t part = 0; part < part_count_of(level); ++part) {
            plain.firsts.push_back(static_cast<uint32_t>(indices.size()) - first);
            for (size_t bin = 0; bin < surface.clean.size(); ++bin) add(part_of(slices.clean(bin), part));
            add(part_of(slices.dirty(), part));
        }
        plain.firsts.push_back(static_cast<uint32_t>(indices.size()) - first);
        plain.ranges.push_back({first, static_cast<uint32_t>(indices.size()) - first});
    }
    if (out.short_indices.empty()) plain.indices = std::move(indices);
    else plain.short_indices.assign(indices.begin(), indices.end());
}

bool one_colour(const PreparedTemplate &prepared, const uint8_t *zone_rgb)
{
    const size_t bytes = prepared.zone_rgb.size();
    return bytes <= 3 || std::memcmp(zone_rgb, zone_rgb + 3, bytes - 3) == 0;
}

void draw_plain(Canvas &canvas, const Individual &individual)
{
    for (uint32_t i = 0; i < individual.level->surfaces.size(); ++i) {
        const model::Surface &surface = individual.level->surfaces[i];
        const PreparedTexture &texture = individual.prepared->textures[surface.texture];
        SurfaceState state = Canvas::state_of(individual, surface);
        if (individual.own || individual.prepared->source->textures[surface.texture].has_holes)
            state.alpha_function = gl::gequal, state.alpha_reference = texture.hole_reference;
        canvas.apply(state);
        canvas.use_zone_colour(individual, i, texture.tests[0]);
        canvas.plain_triangles(individual, i);
    }
}

}  // namespace claque::passes
