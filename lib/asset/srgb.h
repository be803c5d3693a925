// The sRGB transfer curve (IEC 61966-2-1): colours are linear in glTF, but not in glColor.
#pragma once

#include <cstdint>

#include "lib/math/trig.h"

namespace claque::asset
{

// [0, 1] to [0, 1]; values outside are clamped.
inline float encoded(float linear)
{
    const double x = linear < 0 ? 0 : linear > 1 ? 1 : static_cast<double>(linear);
    return static_cast<float>(x <= 0.0031308 ? 12.92 * x : 1.055 * math::pow(x, 1 / 2.4) - 0.055);
}

inline uint8_t byte_of(float unit)
{
    const float x = unit < 0 ? 0 : unit > 1 ? 1 : unit;
    return static_cast<uint8_t>(x * 255 + 0.5f);
}

}  // namespace claque::asset
