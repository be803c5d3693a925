// The instruction set of posing and skinning. All but `fma` give the same bits: the same steps in the same order on
// one, four or eight numbers at a time.
#pragma once

#include <cstdint>

namespace claque::math
{

enum class SimdLevel : uint8_t {
    scalar = 0,
    simd128 = 1,
    simd256 = 2,
    fma = 3  // simd256 with products that are not rounded before they are added: faster, with other bits
};

// The level in use: that of set_simd_level, or else of the environment variable CLAQUE_SIMD (scalar, 128, 256, fma;
// read once), or else the widest of the first three that the processor has. Scalar if the build defines CLAQUE_SCALAR.
SimdLevel default_simd_level();

// Sets the level of the whole process; can_run() must be true for it. Not to be called while a crowd is posed or
// skinned: parts of one update could differ in bits if one of the two levels is `fma`.
void set_simd_level(SimdLevel simd_level);

// True if this processor can run it.
bool can_run(SimdLevel simd_level);

// True if this processor has AVX, with which simd128 takes fewer instructions for the same bits.
bool has_avx();

}  // namespace claque::math
