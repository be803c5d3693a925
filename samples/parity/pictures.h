// Differences as pictures, for people.
#pragma once

#include "samples/parity/ids.h"
#include "samples/parity/map.h"

namespace parity
{

constexpr int difference_gain = 16;  // 16 LSB and more are full brightness

Picture difference_picture(const Picture &reference, const Picture &result);

// [0, 1] from black by violet, red and orange to pale yellow.
Picture heat_picture(const Map<float> &map);

// Where depths differ: from 1e-7 (black) to 1 in equal steps of powers of ten.
Map<float> depth_difference(const Map<float> &reference, const Map<float> &result);

// Where ids differ: at a border amber, elsewhere red, over what the picture shows in dark grey. under: may be null.
Picture marks_picture(const Map<Mark> &marks, const Picture *under);

}  // namespace parity
