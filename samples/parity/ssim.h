// Structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004): windows of 11 x 11 weighted by a Gaussian of 1.5 pixels,
// K1 0.01, K2 0.03, over luma (Rec. 601), only where the window is whole.
#pragma once

#include "samples/parity/map.h"

namespace parity
{

constexpr int ssim_window = 11;  // pictures have to be at least this wide and high

// 1 where both are the same, towards 0 and below where they have nothing in common. Both of one size.
double mean_ssim(const Picture &reference, const Picture &result);

}  // namespace parity
