// Counts the floating-point numbers between two of them.
#pragma once

#include <cstdint>

namespace parity
{

constexpr uint32_t ulp_most = UINT32_MAX;  // not a number on one side, or further apart than 32 bits count

// 0 for equal numbers, and for +0 and -0; 1 for neighbours, also across 0.
uint32_t ulp_distance(float a, float b);

}  // namespace parity
