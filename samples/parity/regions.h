// One region at a time: a share of a picture's pixels says little of an individual that fills a thousandth of it.
#pragma once

#include "samples/parity/map.h"

namespace parity
{

constexpr size_t least_region_pixels = 4;  // what is smaller says nothing

// The region that is worst, of those with at least so many pixels; what lies at a border belongs to none.
struct WorstRegion {
    size_t regions = 0;  // 0: none was large enough, and there is no worst
    uint64_t id = 0;
    size_t pixels = 0;
    double value = 0;
};

// value: the mean difference in LSB of the channel that differs most, over the region.
WorstRegion worst_colour(const Map<uint64_t> &ids, const Picture &reference, const Picture &result);

// value: the median difference of window depth over the region. Id 0, where nobody is, is a region too.
WorstRegion worst_depth(const Map<uint64_t> &ids, const Map<float> &reference, const Map<float> &result);

}  // namespace parity
