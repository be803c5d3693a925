// Rows of packed vertices: what PackJob calls.
#pragma once

#include "lib/skin/pack.h"

namespace claque::skin
{

constexpr float position_limit = 32767, normal_limit = 127;
constexpr float least_square = 1e-30f;  // of a normal's length, so that one of no length is divided by something

// A number within 2^22 of zero, to the nearest whole one, halves to the even one, without a call: added to this one, it loses its fraction.
constexpr float rounder = 12582912;  // 1.5 * 2^23

void pack_scalar(const PackJob &job, uint32_t first);  // from vertex `first` on
uint32_t pack_vector(const PackJob &job);              // how many it did, from the first on

}  // namespace claque::skin
