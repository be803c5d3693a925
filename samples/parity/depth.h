// Window depths of two renderers.
#pragma once

#include "samples/parity/map.h"

namespace parity
{

struct DepthDeviation {
    size_t compared = 0, not_finite = 0;             // pixels that count and where either has a depth below 1
    double max = 0, rms = 0, median = 0, p99_9 = 0;  // of the differences; p99_9: 999 of 1000 are no larger
    int max_x = 0, max_y = 0;
};
// counted: pixels that count, nonzero; empty: all.
DepthDeviation depth_deviation(const Map<float> &reference, const Map<float> &result,
                               const std::vector<uint8_t> &counted);

}  // namespace parity
