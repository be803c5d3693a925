// The rounding steps of packing, for one vertex or four, and the functions of PackJob. Internal to lib/skin.
#pragma once

#include <cmath>
#include <cstring>

#include "lib/skin/pack.h"

namespace claque::skin
{

constexpr float position_limit = 32767, normal_limit = 127;
constexpr float min_square = 1e-30f;  // lower limit of a normal's squared length, so that the division is safe

// Adding this to a value within 2^22 of zero rounds it to the nearest integer, halves to even, without a function call.
constexpr float rounder = 12582912;  // 1.5 * 2^23

// Compares like the processor's minimum and maximum: NaN becomes the limit.
inline float within(float x, float limit)
{
    const float below = x < limit ? x : limit;
    return below > -limit ? below : -limit;
}

inline int32_t nearest(float x)
{
    const float sum = x + rounder;
    int32_t bits, zero;
    std::memcpy(&bits, &sum, 4);
    std::memcpy(&zero, &rounder, 4);
    return bits - zero;
}

inline PackedPosition packed_position(float x, float y, float z, const PackRange &range)
{
    const float per_step = 1 / range.step;
    PackedPosition out;
    out.x = static_cast<int16_t>(nearest(within((x - range.offset[0]) * per_step, position_limit)));
    out.y = static_cast<int16_t>(nearest(within((y - range.offset[1]) * per_step, position_limit)));
    out.z = static_cast<int16_t>(nearest(within((z - range.offset[2]) * per_step, position_limit)));
    return out;
}

inline PackedNormal packed_normal(float x, float y, float z)
{
    const float square = x * x + y * y + z * z;
    const float scale = normal_limit / std::sqrt(square > min_square ? square : min_square);
    PackedNormal out;
    out.x = static_cast<int8_t>(nearest(within(x * scale, normal_limit)));
    out.y = static_cast<int8_t>(nearest(within(y * scale, normal_limit)));
    out.z = static_cast<int8_t>(nearest(within(z * scale, normal_limit)));
    return out;
}

void pack_scalar(const PackJob &job, uint32_t first);  // from vertex `first` on
uint32_t pack_128(const PackJob &job);                 // returns how many vertices it packed, from the first on

}  // namespace claque::skin
