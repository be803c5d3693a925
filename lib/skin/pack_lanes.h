// Four vertices at a time, with x, y and z in separate lanes: with SSE2 the steps of pack_kernel.h in the same order,
// elsewhere those functions themselves. In an unnamed namespace, because each including file may be compiled for other
// processors.
#pragma once

#include "lib/math/simd.h"
#include "lib/skin/pack_kernel.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#define CLAQUE_PACK_INLINE __attribute__((always_inline)) inline

namespace claque::skin
{

namespace
{

#ifdef __SSE2__

CLAQUE_PACK_INLINE __m128 within(__m128 x, float limit)
{
    return _mm_max_ps(_mm_min_ps(x, _mm_set1_ps(limit)), _mm_set1_ps(-limit));
}

CLAQUE_PACK_INLINE __m128i low_of(__m128i high, __m128i low, int bits)
{
    return _mm_or_si128(_mm_slli_epi32(high, bits), _mm_and_si128(low, _mm_set1_epi32((1 << bits) - 1)));
}

class FourPacker
{
public:
    CLAQUE_PACK_INLINE explicit FourPacker(const PackRange &range)
        : offset_{_mm_set1_ps(range.offset[0]), _mm_set1_ps(range.offset[1]), _mm_set1_ps(range.offset[2])},
          per_step_(_mm_set1_ps(1 / range.step))
    {
    }

    CLAQUE_PACK_INLINE void positions(math::F4 x, math::F4 y, math::F4 z, PackedPosition *to) const
    {
        const __m128i xy = low_of(step(y, 1), step(x, 0), 16), zw = low_of(_mm_set1_epi32(1), step(z, 2), 16);
        _mm_storeu_si128(reinterpret_cast<__m128i *>(to), _mm_unpacklo_epi32(xy, zw));
        _mm_storeu_si128(reinterpret_cast<__m128i *>(to + 2), _mm_unpackhi_epi32(xy, zw));
    }

    CLAQUE_PACK_INLINE static void normals(math::F4 x, math::F4 y, math::F4 z, PackedNormal *to)
    {
        const __m128 square = _mm_add_ps(_mm_add_ps(_mm_mul_ps(x, x), _mm_mul_ps(y, y)), _mm_mul_ps(z, z));
        const __m128 length = _mm_sqrt_ps(_mm_max_ps(square, _mm_set1_ps(min_square)));
        const __m128 scale = _mm_div_ps(_mm_set1_ps(normal_limit), length);
        const __m128i z_byte = _mm_and_si128(part(z, scale), _mm_set1_epi32(0xff));
        const __m128i xy = low_of(part(y, scale), part(x, scale), 8);
        _mm_storeu_si128(reinterpret_cast<__m128i *>(to), low_of(z_byte, xy, 16));
    }

private:
    CLAQUE_PACK_INLINE __m128i step(__m128 x, int axis) const
    {
        return _mm_cvtps_epi32(within(_mm_mul_ps(_mm_sub_ps(x, offset_[axis]), per_step_), position_limit));
    }
    CLAQUE_PACK_INLINE static __m128i part(__m128 x, __m128 scale)
    {
        return _mm_cvtps_epi32(within(_mm_mul_ps(x, scale), normal_limit));
    }

    __m128 offset_[3], per_step_;
};

#else

class FourPacker
{
public:
    explicit FourPacker(const PackRange &range) : range_(range) {}
    void positions(math::F4 x, math::F4 y, math::F4 z, PackedPosition *to) const
    {
        for (int i = 0; i < 4; ++i) to[i] = packed_position(x[i], y[i], z[i], range_);
    }
    static void normals(math::F4 x, math::F4 y, math::F4 z, PackedNormal *to)
    {
        for (int i = 0; i < 4; ++i) to[i] = packed_normal(x[i], y[i], z[i]);
    }

private:
    const PackRange &range_;
};

#endif

}  // namespace

}  // namespace claque::skin
