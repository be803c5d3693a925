// Which instruction set posing and skinning run on. All but `fused` give the same bits: the same steps in the same order,
// one number, four or eight at a time.
#pragma once

#include <cstdint>

namespace claque::math
{

enum class SimdLevel : uint8_t {
    scalar = 0,
    simd128 = 1,
    simd256 = 2,
    fma = 3  // wide, with products that are not rounded before they are added: sooner, and of other bits
};

// What runs unless asked otherwise: the widest that the processor has of the first three, or what the environment names
// by CLAQUE_SIMD (scalar, 128, 256, fma), asked once; scalar where the build says CLAQUE_SCALAR; or what use_kernel said.
SimdLevel default_simd_level();

// From here on, for everything in this process; one that can_run. Not while anything is posed or skinned, or parts of
// one update may differ in bits where one of the two is `fused`.
void set_simd_level(SimdLevel simd_level);

// Whether this processor can run it.
bool can_run(SimdLevel simd_level);

}  // namespace claque::math
