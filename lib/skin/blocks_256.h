// Eight vertices that follow the same matrices, a number of each in every lane: a matrix's number is read once for all
// of them. The steps of scalar.cpp in the same order. Compiled twice: what includes it says by macros for which
// processors (CLAQUE_BLOCKS, CLAQUE_BLOCKS_INLINE: attributes of functions, so that nothing the linker may share with
// other files runs where they are not), how a sum takes one product more (CLAQUE_BLOCKS_PLUS_TIMES), and the name of
// the function that it makes (CLAQUE_BLOCKS_RUN).
#pragma once

#include <immintrin.h>

#include "lib/skin/kernel.h"

namespace claque::skin
{

namespace
{

struct Three {
    __m256 x, y, z;
};

CLAQUE_BLOCKS_INLINE __m256 lanes(const model::Lanes &from) { return _mm256_loadu_ps(from.v); }

CLAQUE_BLOCKS_INLINE Three times(const Three &a, __m256 b)
{
    return {_mm256_mul_ps(a.x, b), _mm256_mul_ps(a.y, b), _mm256_mul_ps(a.z, b)};
}

CLAQUE_BLOCKS_INLINE Three plus(const Three &a, const Three &b)
{
    return {_mm256_add_ps(a.x, b.x), _mm256_add_ps(a.y, b.y), _mm256_add_ps(a.z, b.z)};
}

CLAQUE_BLOCKS_INLINE Three plus_times(const Three &sum, const Three &a, __m256 b)
{
    return {CLAQUE_BLOCKS_PLUS_TIMES(sum.x, a.x, b), CLAQUE_BLOCKS_PLUS_TIMES(sum.y, a.y, b),
            CLAQUE_BLOCKS_PLUS_TIMES(sum.z, a.z, b)};
}

CLAQUE_BLOCKS_INLINE Three everywhere(const float *column)
{
    return {_mm256_broadcast_ss(column), _mm256_broadcast_ss(column + 1), _mm256_broadcast_ss(column + 2)};
}

// The matrices of a block and what each lane takes of them.
template <uint32_t K>
struct Mixed {
    const float *matrices[K];
    const model::Lanes *weights;

    CLAQUE_BLOCKS_INLINE Mixed(const float *palette, const model::LaneBlock &block, const model::Lanes *lane_weights)
        : weights(lane_weights)
    {
        for (uint32_t k = 0; k < K; ++k) matrices[k] = palette + aligned_matrix_floats * block.joints[k];
    }
    CLAQUE_BLOCKS_INLINE Three column(int c) const
    {
        Three out = everywhere(matrices[0] + 4 * c);
        if constexpr (K > 1) out = times(out, lanes(weights[0]));
        if constexpr (K > 1) out = plus_times(out, everywhere(matrices[1] + 4 * c), lanes(weights[1]));
        if constexpr (K > 2) out = plus_times(out, everywhere(matrices[2] + 4 * c), lanes(weights[2]));
        if constexpr (K > 3) out = plus_times(out, everywhere(matrices[3] + 4 * c), lanes(weights[3]));
        return out;
    }
};

// x, y and z of eight vertices to 24 numbers, vertex after vertex.
CLAQUE_BLOCKS_INLINE void store(float *out, const Three &v)
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

template <uint32_t K, bool OwnNormalMatrices>
CLAQUE_BLOCKS_INLINE void skin_block(const BlockRun &run, const model::LaneBlock &block, float *positions,
                                     float *normals)
{
    const model::Lanes *in = run.lanes + block.first_lanes;
    const Mixed<K> m(run.palette, block, in + 6);
    const Mixed<K> own(OwnNormalMatrices ? run.normal_palette : run.palette, block, in + 6);
    Three column = m.column(0);
    Three position = times(column, lanes(in[0]));
    Three normal = times(OwnNormalMatrices ? own.column(0) : column, lanes(in[3]));
    column = m.column(1);
    position = plus_times(position, column, lanes(in[1]));
    normal = plus_times(normal, OwnNormalMatrices ? own.column(1) : column, lanes(in[4]));
    column = m.column(2);
    position = plus_times(position, column, lanes(in[2]));
    normal = plus_times(normal, OwnNormalMatrices ? own.column(2) : column, lanes(in[5]));
    store(normals, normal);
    store(positions, plus(position, m.column(3)));
}

}  // namespace

}  // namespace claque::skin

#include "lib/skin/blocks_run.h"
