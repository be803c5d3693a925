// Differences as pictures.
#pragma once

#include "samples/parity/ids.h"
#include "samples/parity/map.h"

namespace parity
{

constexpr int difference_gain = 16;  // 16 LSB and more are full brightness

Picture difference_picture(const Picture &reference, const Picture &result);

// [0, 1] from black by violet, red and orange to pale yellow.
Picture heat_picture(const Map<float> &map);

// Differences of depth: from 1e-7 (black) to 1 on a logarithmic scale.
Map<float> depth_difference(const Map<float> &reference, const Map<float> &result);

// Differences of ids: amber at a border, red elsewhere, over the picture in dark grey. under: may be null.
Picture marks_picture(const Map<Mark> &marks, const Picture *under);

}  // namespace parity
