// Pictures from formulas, so that others can make the same ones.
#pragma once

#include "samples/parity/map.h"

namespace parity
{

// Channel c of pixel (x, y): (x (7 + c) + 13 y + floor(x y / 3) (5 + variant) + 40 c) mod 256.
Picture pattern(int width, int height, int variant);

// The pattern of variant 0 with ((31 x + 17 y) mod 23) - 11 added to every channel, clamped.
Picture noisy_pattern(int width, int height);

Picture inverted(Picture p);
Picture filled(int width, int height, uint8_t value);

}  // namespace parity
