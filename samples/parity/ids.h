// Compares the visible individual and zone, pixel by pixel. Two rasterisers may disagree along a border by a pixel,
// and nowhere else.
#pragma once

#include "samples/parity/map.h"

namespace parity
{

enum class Mark : uint8_t {
    same,
    border,   // different, at a border of the reference, and the id is in the reference one pixel away
    outside,  // different, and no border explains it
    ignored
};

struct IdAgreement {
    size_t compared = 0, different = 0, outside = 0;  // pixels; outside is part of different
    size_t borders = 0;                               // pixels of the reference with another id within a pixel
    int first_x = 0, first_y = 0;                     // of outside, from the top left
    Map<Mark> marks;

    double share() const { return compared == 0 ? 0 : double(different) / double(compared); }
    double outside_share() const { return compared == 0 ? 0 : double(outside) / double(compared); }
    double border_share() const { return borders == 0 ? 0 : double(different - outside) / double(borders); }
};

// Both of one size. seen_alike: pixels that count, nonzero; empty: all.
IdAgreement compare_ids(const Map<uint64_t> &reference, const Map<uint64_t> &result,
                        const std::vector<uint8_t> &seen_alike);

// True if another id is within a pixel.
bool at_border(const Map<uint64_t> &ids, int x, int y);

Map<uint64_t> actor_ids(const Map<uint32_t> &actor);
// One id for each zone of each actor, so that a neighbour's zone explains nothing.
Map<uint64_t> zone_ids(const Map<uint32_t> &actor, const Map<uint16_t> &zone);

}  // namespace parity
