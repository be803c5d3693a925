// Measures of one region at a time, because a share of a picture's pixels says little of an individual that fills a
// thousandth of it.
#pragma once

#include "samples/parity/map.h"

namespace parity
{

// Smaller regions are ignored.
constexpr size_t least_region_pixels = 4, least_bias_pixels = 16;

// Pixels that count, nonzero; empty: all.
using Counted = std::vector<uint8_t>;

// The worst region of those with enough pixels.
struct WorstRegion {
    size_t regions = 0;  // 0: none was large enough, and there is no worst one
    uint64_t id = 0;
    size_t pixels = 0;
    double value = 0;
};

// Of regions without their border pixels; id 0, the background, is a region too.
// value: the mean difference in LSB of the channel that differs most.
WorstRegion worst_colour(const Map<uint64_t> &ids, const Picture &reference, const Picture &result,
                         const Counted &counted);
// value: the median difference of window depth.
WorstRegion worst_depth(const Map<uint64_t> &ids, const Map<float> &reference, const Map<float> &result,
                        const Counted &counted);
// value: the share of pixels at which the result has another id.
WorstRegion worst_ids(const Map<uint64_t> &reference, const Map<uint64_t> &result, const Counted &counted);

// Of whole regions. value: the difference in LSB of the mean colours, of the channel that differs most. Texels that lie
// a part of a pixel elsewhere cancel out in it; another light or colour does not.
WorstRegion worst_bias(const Map<uint64_t> &ids, const Picture &reference, const Picture &result,
                       const Counted &counted);

}  // namespace parity
