// Eight vertices that follow the same matrices, a number of each in every lane: a matrix's number is read once for all
// of them. The steps of scalar.cpp in the same order. Compiled twice: what includes it says by macros for which
// processors (CLAQUE_BLOCKS, CLAQUE_BLOCKS_INLINE: attributes of functions, so that nothing the linker may share with
// other files runs where they are not), how a sum takes one product more (CLAQUE_BLOCKS_PLUS_TIMES), and the name of
// the function that it makes (CLAQUE_BLOCKS_RUN).
#pragma once

#include <immintrin.h>

#include "lib/skin/blocks_256_forms.h"
#include "lib/skin/kernel.h"

namespace claque::skin
{

namespace
{

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

template <uint32_t K, bool OwnNormalMatrices>
CLAQUE_BLOCKS_INLINE Vertices skin_block(const BlockRun &run, const model::LaneBlock &block)
{
    const model::Lanes *in = run.lanes + block.first_lanes;
    const Mixed<K> m(run.palette, block, in + 6);
    const Mixed<K> own(OwnNormalMatrices ? run.normal_palette : run.palette, block, in + 6);
    Vertices out;
    Three column = m.column(0);
    out.position = times(column, lanes(in[0]));
    out.normal = times(OwnNormalMatrices ? own.column(0) : column, lanes(in[3]));
    column = m.column(1);
    out.position = plus_times(out.position, column, lanes(in[1]));
    out.normal = plus_times(out.normal, OwnNormalMatrices ? own.column(1) : column, lanes(in[4]));
    column = m.column(2);
    out.position = plus_times(out.position, column, lanes(in[2]));
    out.normal = plus_times(out.normal, OwnNormalMatrices ? own.column(2) : column, lanes(in[5]));
    out.position = plus(out.position, m.column(3));
    return out;
}

}  // namespace

}  // namespace claque::skin

#include "lib/skin/blocks_run.h"
