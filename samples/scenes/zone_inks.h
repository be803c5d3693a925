// Colours that zones are painted with in pictures.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace scenes
{

using Ink = std::array<uint8_t, 3>;

// Hue as a part of the circle, which may be any number; saturation and brightness in [0, 1].
Ink ink_of(double hue, double saturation, double brightness);

// Inks that are easily told apart: hues by the golden angle, alternating light and dark.
Ink zone_ink(size_t zone);

// As "#f2523d".
std::string hex_of(const Ink &ink);

}  // namespace scenes
