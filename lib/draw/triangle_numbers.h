// The numbers of triangles: those of one individual after another in the order of the draw list, all of its level,
// whether they are drawn or not. Within a level: surface by surface, its clean bins, then its dirty triangles, as
// clq_template_get_triangles gives them.
#pragma once

#include "lib/draw/draw_list.h"

namespace claque::draw
{

// Calls with (surface, range, zone_index, part_offsets) for each bin. zone_index: of the texture's keys, or none for
// dirty triangles. part_offsets: as Surface::part_offsets for this range, or null.
template <class Visit>
void for_bins(const model::Level &level, const Visit &visit)
{
    for (const model::Surface &surface : level.surfaces) {
        const uint32_t *parts = surface.part_offsets.empty() ? nullptr : surface.part_offsets.data();
        for (const model::Bin &bin : surface.clean) {
            visit(surface, bin.range, bin.zone_index, parts);
            if (parts) parts += level.parts.size() + 1;
        }
        if (surface.dirty.count != 0) visit(surface, surface.dirty, model::none, parts);
    }
}

inline uint32_t triangle_count(const model::Level &level)
{
    uint32_t count = 0;
    for_bins(level, [&](const model::Surface &, const model::IndexRange &range, uint32_t, const uint32_t *) {
        count += range.count / 3;
    });
    return count;
}

inline uint64_t triangle_count(const DrawList &list)
{
    uint64_t count = 0;
    for (const Item &item : list.items) count += triangle_count(item.tmpl->levels[item.level]);
    return count;
}

}  // namespace claque::draw
