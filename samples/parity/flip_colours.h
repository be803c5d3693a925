// The colour spaces of LDR-FLIP and the largest possible difference in them (Andersson et al. 2020, 4.1).
#pragma once

#include <array>
#include <cstdint>

namespace parity::flip
{

using Colour = std::array<float, 3>;

Colour linear_of(const uint8_t *srgb);     // [0, 1] a channel
Colour opponent_of(const Colour &linear);  // YCxCz: linear in light, so that it may be filtered
Colour linear_of_opponent(const Colour &opponent);

// CIELAB under D65 with chroma scaled by lightness (Hunt effect).
Colour hunt_lab_of(const Colour &linear);

float hyab(const Colour &a, const Colour &b);  // |dL| + the Euclidean distance of chroma
float largest_difference();                    // hyab of pure green and pure blue, to the power of 0.7

}  // namespace parity::flip
