// Skins eight vertices that follow the same matrices, as two times four lanes. Each matrix element is broadcast once
// for all of them. It works row by row, so that the working set fits into 16 registers, and does the steps of
// scalar.cpp in the same order. It is compiled twice, like blocks_256.h. CLAQUE_BLOCKS_BROADCAST means that the
// processor broadcasts an element as it loads it. Otherwise integers are shuffled, because SSE2 has an integer shuffle
// with a memory operand.
#pragma once

#include "lib/math/simd.h"
#include "lib/skin/kernel.h"
#include "lib/skin/pack_lanes.h"

namespace claque::skin
{

namespace
{

using math::F4;
typedef int I4 __attribute__((vector_size(16)));

template <class V>
CLAQUE_BLOCKS_INLINE V aligned(const float *p)
{
    return *static_cast<const V *>(__builtin_assume_aligned(p, 16));
}

template <int I>
CLAQUE_BLOCKS_INLINE F4 spread(const float *column)
{
#if defined(CLAQUE_BLOCKS_BROADCAST)
    return F4{column[I], column[I], column[I], column[I]};
#elif defined(__clang__)
    const I4 v = aligned<I4>(column);
    return reinterpret_cast<F4>(__builtin_shufflevector(v, v, I, I, I, I));
#else
    return reinterpret_cast<F4>(__builtin_shuffle(aligned<I4>(column), I4{I, I, I, I}));
#endif
}

// The same coordinate of eight vertices.
struct Float8 {
    F4 low, high;
};

CLAQUE_BLOCKS_INLINE Float8 lanes(const model::Lanes &from) { return {aligned<F4>(from.v), aligned<F4>(from.v + 4)}; }
CLAQUE_BLOCKS_INLINE Float8 operator*(const Float8 &a, const Float8 &b) { return {a.low * b.low, a.high * b.high}; }
CLAQUE_BLOCKS_INLINE Float8 operator*(F4 a, const Float8 &b) { return {a * b.low, a * b.high}; }
CLAQUE_BLOCKS_INLINE Float8 operator+(const Float8 &a, const Float8 &b) { return {a.low + b.low, a.high + b.high}; }

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
    template <int Row>
    CLAQUE_BLOCKS_INLINE Float8 number(int column) const
    {
        const F4 first = spread<Row>(matrices[0] + 4 * column);
        if constexpr (K == 1) {
            return {first, first};
        } else {
            Float8 out = first * lanes(weights[0]);
            out = out + spread<Row>(matrices[1] + 4 * column) * lanes(weights[1]);
            if constexpr (K > 2) out = out + spread<Row>(matrices[2] + 4 * column) * lanes(weights[2]);
            if constexpr (K > 3) out = out + spread<Row>(matrices[3] + 4 * column) * lanes(weights[3]);
            return out;
        }
    }
};

template <uint32_t K, bool OwnNormalMatrices, int Row>
CLAQUE_BLOCKS_INLINE void skin_row(const BlendedMatrix<K> &m, const BlendedMatrix<K> &own, const model::Lanes *in,
                                   Float8 *position, Float8 *normal)
{
    const Float8 x = m.template number<Row>(0), y = m.template number<Row>(1), z = m.template number<Row>(2);
    position[Row] = x * lanes(in[0]) + y * lanes(in[1]) + z * lanes(in[2]) + m.template number<Row>(3);
    if constexpr (OwnNormalMatrices)
        normal[Row] = own.template number<Row>(0) * lanes(in[3]) + own.template number<Row>(1) * lanes(in[4]) +
                      own.template number<Row>(2) * lanes(in[5]);
    else normal[Row] = x * lanes(in[3]) + y * lanes(in[4]) + z * lanes(in[5]);
}

template <int A, int B, int C, int D>
CLAQUE_BLOCKS_INLINE F4 mix(F4 a, F4 b)
{
#if defined(__clang__)
    return __builtin_shufflevector(a, b, A, B, C + 4, D + 4);
#else
    return __builtin_shuffle(a, b, I4{A, B, C + 4, D + 4});
#endif
}

struct Floats {
    using Position = Float3;
    using Normal = Float3;
    Float3 *positions, *normals;

    CLAQUE_BLOCKS_INLINE explicit Floats(const BlockRun &run) : positions(run.out_positions), normals(run.out_normals)
    {
    }

    CLAQUE_BLOCKS_INLINE static void write_positions(const Float8 v[3], Float3 *to)
    {
        store(&to[0].x, v[0].low, v[1].low, v[2].low);
        store(&to[4].x, v[0].high, v[1].high, v[2].high);
    }
    CLAQUE_BLOCKS_INLINE static void write_normals(const Float8 v[3], Float3 *to) { write_positions(v, to); }

private:
    // Stores x, y and z of four vertices as twelve floats, vertex after vertex.
    CLAQUE_BLOCKS_INLINE static void store(float *out, F4 x, F4 y, F4 z)
    {
        const F4 xy = mix<0, 2, 0, 2>(x, y), yz = mix<1, 3, 1, 3>(y, z), zx = mix<0, 2, 1, 3>(z, x);
        math::store4(out, mix<0, 2, 0, 2>(xy, zx));
        math::store4(out + 4, mix<0, 2, 1, 3>(yz, xy));
        math::store4(out + 8, mix<1, 3, 1, 3>(zx, yz));
    }
};

struct Packed {
    using Position = PackedPosition;
    using Normal = PackedNormal;
    PackedPosition *positions;
    PackedNormal *normals;

    CLAQUE_BLOCKS_INLINE explicit Packed(const BlockRun &run)
        : positions(run.packed.positions), normals(run.packed.normals), packer_(run.packed.range)
    {
    }

    CLAQUE_BLOCKS_INLINE void write_positions(const Float8 v[3], PackedPosition *to) const
    {
        packer_.positions(v[0].low, v[1].low, v[2].low, to);
        packer_.positions(v[0].high, v[1].high, v[2].high, to + 4);
    }
    CLAQUE_BLOCKS_INLINE static void write_normals(const Float8 v[3], PackedNormal *to)
    {
        FourPacker::normals(v[0].low, v[1].low, v[2].low, to);
        FourPacker::normals(v[0].high, v[1].high, v[2].high, to + 4);
    }

private:
    FourPacker packer_;
};

template <uint32_t K, bool OwnNormalMatrices, class Form>
CLAQUE_BLOCKS_INLINE void skin_block(const BlockRun &run, const model::LaneBlock &block, const Form &form,
                                     typename Form::Position *positions, typename Form::Normal *normals)
{
    const model::Lanes *in = run.lanes + block.first_lanes;
    const BlendedMatrix<K> m(run.palette, block, in + 6);
    const BlendedMatrix<K> own(OwnNormalMatrices ? run.normal_palette : run.palette, block, in + 6);
    Float8 position[3], normal[3];
    skin_row<K, OwnNormalMatrices, 0>(m, own, in, position, normal);
    skin_row<K, OwnNormalMatrices, 1>(m, own, in, position, normal);
    skin_row<K, OwnNormalMatrices, 2>(m, own, in, position, normal);
    form.write_positions(position, positions);
    form.write_normals(normal, normals);
}

}  // namespace

}  // namespace claque::skin

#include "lib/skin/blocks_run.h"
