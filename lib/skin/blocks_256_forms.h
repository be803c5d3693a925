// Stores eight vertices as floats or packed: see blocks_run.h, and blocks_256.h for the macros.
#pragma once

#include <immintrin.h>

#include "lib/skin/kernel.h"
#include "lib/skin/pack_kernel.h"

namespace claque::skin
{

namespace
{

struct Float8x3 {
    __m256 x, y, z;
};

struct Floats {
    using Position = Float3;
    using Normal = Float3;
    Float3 *positions, *normals;

    CLAQUE_BLOCKS_INLINE explicit Floats(const BlockRun &run) : positions(run.out_positions), normals(run.out_normals)
    {
    }

    CLAQUE_BLOCKS_INLINE static void write_positions(const Float8x3 &v, Float3 *to) { store(&to->x, v); }
    CLAQUE_BLOCKS_INLINE static void write_normals(const Float8x3 &v, Float3 *to) { store(&to->x, v); }

private:
    // Stores x, y and z of eight vertices as 24 floats, vertex after vertex.
    CLAQUE_BLOCKS_INLINE static void store(float *out, const Float8x3 &v)
    {
        const __m256 xy = _mm256_shuffle_ps(v.x, v.y, _MM_SHUFFLE(2, 0, 2, 0));  // x0 x2 y0 y2 of each half
        const __m256 yz = _mm256_shuffle_ps(v.y, v.z, _MM_SHUFFLE(3, 1, 3, 1));  // y1 y3 z1 z3
        const __m256 zx = _mm256_shuffle_ps(v.z, v.x, _MM_SHUFFLE(3, 1, 2, 0));  // z0 z2 x1 x3
        const __m256 a = _mm256_shuffle_ps(xy, zx, _MM_SHUFFLE(2, 0, 2, 0));     // x0 y0 z0 x1
        const __m256 b = _mm256_shuffle_ps(yz, xy, _MM_SHUFFLE(3, 1, 2, 0));     // y1 z1 x2 y2
        const __m256 c = _mm256_shuffle_ps(zx, yz, _MM_SHUFFLE(3, 1, 3, 1));     // z2 x3 y3 z3
        _mm_storeu_ps(out, _mm256_castps256_ps128(a));
        _mm_storeu_ps(out + 4, _mm256_castps256_ps128(b));
        _mm_storeu_ps(out + 8, _mm256_castps256_ps128(c));
        _mm_storeu_ps(out + 12, _mm256_extractf128_ps(a, 1));
        _mm_storeu_ps(out + 16, _mm256_extractf128_ps(b, 1));
        _mm_storeu_ps(out + 20, _mm256_extractf128_ps(c, 1));
    }
};

// The steps of pack_kernel.h in the same order.
struct Packed {
    using Position = PackedPosition;
    using Normal = PackedNormal;
    PackedPosition *positions;
    PackedNormal *normals;

    CLAQUE_BLOCKS_INLINE explicit Packed(const BlockRun &run)
        : positions(run.packed.positions),
          normals(run.packed.normals),
          offset_{_mm256_set1_ps(run.packed.range.offset[0]), _mm256_set1_ps(run.packed.range.offset[1]),
                  _mm256_set1_ps(run.packed.range.offset[2])},
          per_step_(_mm256_set1_ps(1 / run.packed.range.step))
    {
    }

    CLAQUE_BLOCKS_INLINE void write_positions(const Float8x3 &p, PackedPosition *to) const
    {
        const __m256i x = step(p.x, offset_.x), y = step(p.y, offset_.y), z = step(p.z, offset_.z);
        const __m256i xy = _mm256_blend_epi16(x, _mm256_slli_epi32(y, 16), 0xaa);
        const __m256i zw = _mm256_blend_epi16(z, _mm256_set1_epi32(1 << 16), 0xaa);
        // vertices 0 1 4 5, 2 3 6 7
        const __m256i a = _mm256_unpacklo_epi32(xy, zw), b = _mm256_unpackhi_epi32(xy, zw);
        _mm256_storeu_si256(reinterpret_cast<__m256i *>(to), _mm256_permute2x128_si256(a, b, 0x20));
        _mm256_storeu_si256(reinterpret_cast<__m256i *>(to + 4), _mm256_permute2x128_si256(a, b, 0x31));
    }

    CLAQUE_BLOCKS_INLINE static void write_normals(const Float8x3 &n, PackedNormal *to)
    {
        const __m256 square =
            _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(n.x, n.x), _mm256_mul_ps(n.y, n.y)), _mm256_mul_ps(n.z, n.z));
        const __m256 length = _mm256_sqrt_ps(_mm256_max_ps(square, _mm256_set1_ps(min_square)));
        const __m256 scale = _mm256_div_ps(_mm256_set1_ps(normal_limit), length);
        const __m256i byte = _mm256_set1_epi32(0xff);
        const __m256i x = _mm256_and_si256(whole(_mm256_mul_ps(n.x, scale), normal_limit), byte);
        const __m256i y = _mm256_slli_epi32(whole(_mm256_mul_ps(n.y, scale), normal_limit), 8);
        const __m256i z = _mm256_and_si256(whole(_mm256_mul_ps(n.z, scale), normal_limit), byte);
        _mm256_storeu_si256(reinterpret_cast<__m256i *>(to),
                            _mm256_blend_epi16(_mm256_or_si256(x, y), _mm256_slli_epi32(z, 16), 0xaa));
    }

private:
    CLAQUE_BLOCKS_INLINE static __m256i whole(__m256 x, float limit)
    {
        return _mm256_cvtps_epi32(_mm256_max_ps(_mm256_min_ps(x, _mm256_set1_ps(limit)), _mm256_set1_ps(-limit)));
    }
    CLAQUE_BLOCKS_INLINE __m256i step(__m256 x, __m256 offset) const
    {
        return whole(_mm256_mul_ps(_mm256_sub_ps(x, offset), per_step_), position_limit);
    }

    Float8x3 offset_;
    __m256 per_step_;
};

}  // namespace

}  // namespace claque::skin
