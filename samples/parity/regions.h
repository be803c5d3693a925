// Measures of one region at a time, because a share of a picture's pixels says little of an individual that fills a
// thousandth of it.
#pragma once

#include "samples/parity/map.h"

namespace parity
{

constexpr size_t least_region_pixels = 4;  // smaller regions are ignored

// The worst region of those with at least this many pixels; border pixels belong to none.
struct WorstRegion {
    size_t regions = 0;  // 0: none was large enough, and there is no worst one
    uint64_t id = 0;
    size_t pixels = 0;
    double value = 0;
};

// value: the mean difference in LSB of the channel that differs most, over the region.
WorstRegion worst_colour(const Map<uint64_t> &ids, const Picture &reference, const Picture &result);

// value: the median difference of window depth over the region. Id 0, the background, is a region too.
WorstRegion worst_depth(const Map<uint64_t> &ids, const Map<float> &reference, const Map<float> &result);

}  // namespace parity
