// Which instruction set posing and skinning run on. All give the same bits: the same steps in the same order, one number,
// four or eight at a time.
#pragma once

#include <cstdint>

namespace claque::math
{

enum class Kernel : uint8_t { scalar = 0, vector = 1, wide = 2 };

// What runs unless asked otherwise: the widest that the processor has, or that the environment names by CLAQUE_SIMD
// (scalar, 128, 256); scalar where the build says CLAQUE_SCALAR. Asked once.
Kernel default_kernel();

// Whether this processor can run it.
bool can_run(Kernel kernel);

}  // namespace claque::math
