// The parts of a level that are drawn (S0 4.2, phase 3), and their offsets in each range of a surface's triangles.
#pragma once

#include <bitset>

#include "lib/model/template.h"

namespace claque::passes
{

// A level without a list of parts has one part.
inline uint32_t part_count_of(const model::Level &level)
{
    return level.parts.empty() ? 1 : static_cast<uint32_t>(level.parts.size());
}

inline uint64_t every_part_of(const model::Level &level)
{
    const uint32_t count = part_count_of(level);
    return count >= model::max_level_parts ? ~uint64_t(0) : (uint64_t(1) << count) - 1;
}

inline uint32_t count_of(uint64_t parts) { return static_cast<uint32_t>(std::bitset<64>(parts).count()); }

// A range of a surface's triangles and the offsets of the level's parts in it: one more than there are parts. Null: one
// part.
struct IndexSlice {
    model::IndexRange range;
    const uint32_t *firsts = nullptr;
};

// The ranges of a surface in the order of model::Surface::part_offsets.
class IndexSlices
{
public:
    IndexSlices(const model::Level &level, const model::Surface &surface)
        : surface_(surface), row_(level.parts.size() + 1), clean_(surface.clean.size())
    {
    }
    IndexSlice clean(size_t bin) const { return {surface_.clean[bin].range, row(bin)}; }
    IndexSlice dirty() const { return {surface_.dirty, row(clean_)}; }
    IndexSlice by_zone(size_t bin) const { return {surface_.dirty_by_zone[bin].range, row(clean_ + 1 + bin)}; }
    IndexSlice fused() const { return {surface_.fused, row(count() - 1)}; }

    size_t count() const { return clean_ + surface_.dirty_by_zone.size() + 2; }
    IndexSlice operator[](size_t i) const
    {
        if (i < clean_) return clean(i);
        if (i == clean_) return dirty();
        return i + 1 < count() ? by_zone(i - clean_ - 1) : fused();
    }

private:
    const uint32_t *row(size_t i) const
    {
        return surface_.part_offsets.empty() ? nullptr : surface_.part_offsets.data() + i * row_;
    }
    const model::Surface &surface_;
    size_t row_, clean_;
};

// The range of one part.
inline model::IndexRange part_of(const IndexSlice &slice, uint32_t part)
{
    if (!slice.firsts) return slice.range;
    return {slice.range.first + slice.firsts[part], slice.firsts[part + 1] - slice.firsts[part]};
}

// Calls draw(range) for the ranges of `parts` in a slice; neighbouring parts are one range, in order.
template <class Draw>
void for_runs(const IndexSlice &slice, uint64_t parts, uint32_t part_count, Draw draw)
{
    model::IndexRange run = {slice.range.first, 0};
    for (uint32_t part = 0; part < part_count; ++part) {
        if (!(parts >> part & 1)) continue;
        const model::IndexRange share = part_of(slice, part);
        if (share.count == 0) continue;
        if (run.count != 0 && run.first + run.count != share.first) {
            draw(run);
            run.count = 0;
        }
        if (run.count == 0) run.first = share.first;
        run.count += share.count;
    }
    if (run.count != 0) draw(run);
}

inline bool any_of(const IndexSlice &slice, uint64_t parts, uint32_t part_count)
{
    for (uint32_t part = 0; part < part_count; ++part)
        if ((parts >> part & 1) && part_of(slice, part).count != 0) return true;
    return false;
}

}  // namespace claque::passes
