// Four floats at once in the compilers' own vector types. Multiply and add are separate on any processor and give the
// same bits as scalar code with the same steps in the same order.
#pragma once

#include <cstring>

namespace claque::math
{

typedef float F4 __attribute__((vector_size(16)));

inline F4 load4(const float *p)
{
    F4 v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

inline void store4(float *p, F4 v) { std::memcpy(p, &v, sizeof v); }
inline void store3(float *p, F4 v) { std::memcpy(p, &v, 3 * sizeof(float)); }
// Rotates lanes 0 to 2 by one, for cross products.
inline F4 yzx(F4 v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); }
inline F4 splat(float x) { return F4{x, x, x, x}; }

// An affine matrix as four columns of four lanes, lane 3 unused: the form for chains of products.
struct Columns {
    F4 c[4];
};

}  // namespace claque::math
