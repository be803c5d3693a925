// Four vertices at a time with SSE2: the steps of pack.cpp in the same order. Other processors take its loop.
#include "lib/skin/pack_kernel.h"

#ifdef __SSE2__

#include <emmintrin.h>

namespace claque::skin
{

namespace
{

__m128 within(__m128 x, float limit) { return _mm_max_ps(_mm_min_ps(x, _mm_set1_ps(limit)), _mm_set1_ps(-limit)); }

__m128i nearest(__m128 x)
{
    const __m128 zero = _mm_set1_ps(rounder);
    return _mm_sub_epi32(_mm_castps_si128(_mm_add_ps(x, zero)), _mm_castps_si128(zero));
}

// Three numbers of each of four vertices to the vertices' x, y and z.
struct Four {
    __m128 x, y, z;

    explicit Four(const float *p)
    {
        const __m128 a = _mm_loadu_ps(p), b = _mm_loadu_ps(p + 4), c = _mm_loadu_ps(p + 8);
        const __m128 bc = _mm_shuffle_ps(b, c, _MM_SHUFFLE(2, 1, 3, 2));  // x2 y2 x3 y3
        const __m128 ab = _mm_shuffle_ps(a, b, _MM_SHUFFLE(1, 0, 2, 1));  // y0 z0 y1 z1
        x = _mm_shuffle_ps(a, bc, _MM_SHUFFLE(2, 0, 3, 0));
        y = _mm_shuffle_ps(ab, bc, _MM_SHUFFLE(3, 1, 2, 0));
        z = _mm_shuffle_ps(ab, c, _MM_SHUFFLE(3, 0, 3, 1));
    }
};

__m128i low_of(__m128i high, __m128i low, int bits)
{
    return _mm_or_si128(_mm_slli_epi32(high, bits), _mm_and_si128(low, _mm_set1_epi32((1 << bits) - 1)));
}

void pack_positions(const float *from, const __m128 offset[3], __m128 per_step, PackedPosition *to)
{
    const Four p(from);
    const __m128i x = nearest(within(_mm_mul_ps(_mm_sub_ps(p.x, offset[0]), per_step), position_limit));
    const __m128i y = nearest(within(_mm_mul_ps(_mm_sub_ps(p.y, offset[1]), per_step), position_limit));
    const __m128i z = nearest(within(_mm_mul_ps(_mm_sub_ps(p.z, offset[2]), per_step), position_limit));
    const __m128i xy = low_of(y, x, 16), zw = low_of(_mm_set1_epi32(1), z, 16);
    _mm_storeu_si128(reinterpret_cast<__m128i *>(to), _mm_unpacklo_epi32(xy, zw));
    _mm_storeu_si128(reinterpret_cast<__m128i *>(to + 2), _mm_unpackhi_epi32(xy, zw));
}

void pack_normals(const float *from, PackedNormal *to)
{
    const Four n(from);
    const __m128 square = _mm_add_ps(_mm_add_ps(_mm_mul_ps(n.x, n.x), _mm_mul_ps(n.y, n.y)), _mm_mul_ps(n.z, n.z));
    const __m128 length = _mm_sqrt_ps(_mm_max_ps(square, _mm_set1_ps(least_square)));
    const __m128 scale = _mm_div_ps(_mm_set1_ps(normal_limit), length);
    const __m128i x = nearest(within(_mm_mul_ps(n.x, scale), normal_limit));
    const __m128i y = nearest(within(_mm_mul_ps(n.y, scale), normal_limit));
    const __m128i z = nearest(within(_mm_mul_ps(n.z, scale), normal_limit));
    const __m128i low_byte = _mm_set1_epi32(0xff);
    _mm_storeu_si128(reinterpret_cast<__m128i *>(to), low_of(_mm_and_si128(z, low_byte), low_of(y, x, 8), 16));
}

}  // namespace

uint32_t pack_vector(const PackJob &job)
{
    const uint32_t done = job.out_positions.count & ~3u;
    const __m128 per_step = _mm_set1_ps(1 / job.range.step);
    const __m128 offset[3] = {_mm_set1_ps(job.range.offset[0]), _mm_set1_ps(job.range.offset[1]),
                              _mm_set1_ps(job.range.offset[2])};
    for (uint32_t v = 0; v < done; v += 4) {
        pack_positions(job.positions.data + 3 * size_t(v), offset, per_step, job.out_positions.data + v);
        pack_normals(job.normals.data + 3 * size_t(v), job.out_normals.data + v);
    }
    return done;
}

}  // namespace claque::skin

#else

namespace claque::skin
{

uint32_t pack_vector(const PackJob &) { return 0; }

}  // namespace claque::skin

#endif
