// Skins eight vertices that follow the same matrices, one per lane. Each matrix element is loaded once for all of them.
// It does the steps of scalar.cpp in the same order. It is compiled twice, and the including file defines macros:
// CLAQUE_BLOCKS and CLAQUE_BLOCKS_INLINE, the function attributes that select the processors (so that no function that
// the linker may share with other files uses their instructions); CLAQUE_BLOCKS_PLUS_TIMES, which adds a product to a
// sum; and CLAQUE_BLOCKS_RUN, the name of the resulting function.
#pragma once

#include <immintrin.h>

#include "lib/skin/blocks_256_forms.h"
#include "lib/skin/kernel.h"

namespace claque::skin
{

namespace
{

CLAQUE_BLOCKS_INLINE __m256 lanes(const model::Lanes &from) { return _mm256_loadu_ps(from.v); }

CLAQUE_BLOCKS_INLINE Float8x3 times(const Float8x3 &a, __m256 b)
{
    return {_mm256_mul_ps(a.x, b), _mm256_mul_ps(a.y, b), _mm256_mul_ps(a.z, b)};
}

CLAQUE_BLOCKS_INLINE Float8x3 plus(const Float8x3 &a, const Float8x3 &b)
{
    return {_mm256_add_ps(a.x, b.x), _mm256_add_ps(a.y, b.y), _mm256_add_ps(a.z, b.z)};
}

CLAQUE_BLOCKS_INLINE Float8x3 plus_times(const Float8x3 &sum, const Float8x3 &a, __m256 b)
{
    return {CLAQUE_BLOCKS_PLUS_TIMES(sum.x, a.x, b), CLAQUE_BLOCKS_PLUS_TIMES(sum.y, a.y, b),
            CLAQUE_BLOCKS_PLUS_TIMES(sum.z, a.z, b)};
}

// The matrices of a block and the weight of each in each lane.
template <uint32_t K>
struct BlendedMatrix {
    const float *matrices[K];
    const model::Lanes *weights;

    CLAQUE_BLOCKS_INLINE BlendedMatrix(const float *palette, const model::LaneBlock &block,
                                       const model::Lanes *lane_weights)
        : weights(lane_weights)
    {
        for (uint32_t k = 0; k < K; ++k) matrices[k] = palette + aligned_matrix_floats * block.joints[k];
    }
    // One element after the other, so that few registers are in use beside the sums.
    CLAQUE_BLOCKS_INLINE Float8x3 column(int c) const { return {number(4 * c), number(4 * c + 1), number(4 * c + 2)}; }

private:
    CLAQUE_BLOCKS_INLINE __m256 number(int i) const
    {
        __m256 out = _mm256_broadcast_ss(matrices[0] + i);
        if constexpr (K > 1) out = _mm256_mul_ps(out, lanes(weights[0]));
        if constexpr (K > 1) out = plus_times(out, 1, i);
        if constexpr (K > 2) out = plus_times(out, 2, i);
        if constexpr (K > 3) out = plus_times(out, 3, i);
        return out;
    }
    CLAQUE_BLOCKS_INLINE __m256 plus_times(__m256 sum, int k, int i) const
    {
        return CLAQUE_BLOCKS_PLUS_TIMES(sum, _mm256_broadcast_ss(matrices[k] + i), lanes(weights[k]));
    }
};

template <uint32_t K, bool OwnNormalMatrices, class Form>
CLAQUE_BLOCKS_INLINE void skin_block(const BlockRun &run, const model::LaneBlock &block, const Form &form,
                                     typename Form::Position *positions, typename Form::Normal *normals)
{
    const model::Lanes *in = run.lanes + block.first_lanes;
    const BlendedMatrix<K> m(run.palette, block, in + 6);
    const BlendedMatrix<K> own(OwnNormalMatrices ? run.normal_palette : run.palette, block, in + 6);
    Float8x3 column = m.column(0);
    Float8x3 position = times(column, lanes(in[0]));
    Float8x3 normal = times(OwnNormalMatrices ? own.column(0) : column, lanes(in[3]));
    column = m.column(1);
    position = plus_times(position, column, lanes(in[1]));
    normal = plus_times(normal, OwnNormalMatrices ? own.column(1) : column, lanes(in[4]));
    column = m.column(2);
    position = plus_times(position, column, lanes(in[2]));
    normal = plus_times(normal, OwnNormalMatrices ? own.column(2) : column, lanes(in[5]));
    form.write_normals(normal, normals);
    form.write_positions(plus(position, m.column(3)), positions);
}

}  // namespace

}  // namespace claque::skin

#include "lib/skin/blocks_run.h"
