// Structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004): windows of 11 x 11 weighted by a Gaussian of 1.5
// pixels, K1 0.01, K2 0.03, over luma (Rec. 601), for whole windows only.
#pragma once

#include "samples/parity/map.h"

namespace parity
{

constexpr int ssim_window = 11;  // minimum width and height of pictures

// 1 for equal pictures, 0 and below for pictures without common structure. Both of one size.
double mean_ssim(const Picture &reference, const Picture &result);

}  // namespace parity
