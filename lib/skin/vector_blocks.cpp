// Eight vertices that follow the same matrices, as two times four lanes: each number of a matrix is spread once for
// all of them. Row after row, so that what is at work fits into 16 registers. The steps of scalar.cpp in the same order.
#include "lib/math/simd.h"
#include "lib/skin/kernel.h"
#include "lib/skin/pack_lanes.h"

#define CLAQUE_INLINE __attribute__((always_inline)) inline

namespace claque::skin
{

namespace
{

using math::F4;
typedef int I4 __attribute__((vector_size(16)));

template <class V>
CLAQUE_INLINE V aligned(const float *p)
{
    return *static_cast<const V *>(__builtin_assume_aligned(p, 16));
}

// A shuffle of whole numbers, because SSE2 has one that reads memory for them.
template <int I>
CLAQUE_INLINE F4 spread(const float *column)
{
    const I4 v = aligned<I4>(column);
#if defined(__clang__)
    return reinterpret_cast<F4>(__builtin_shufflevector(v, v, I, I, I, I));
#else
    return reinterpret_cast<F4>(__builtin_shuffle(v, I4{I, I, I, I}));
#endif
}

// The same number of eight vertices.
struct Eight {
    F4 low, high;
};

CLAQUE_INLINE Eight lanes(const model::Lanes &from) { return {aligned<F4>(from.v), aligned<F4>(from.v + 4)}; }
CLAQUE_INLINE Eight operator*(const Eight &a, const Eight &b) { return {a.low * b.low, a.high * b.high}; }
CLAQUE_INLINE Eight operator*(F4 a, const Eight &b) { return {a * b.low, a * b.high}; }
CLAQUE_INLINE Eight operator+(const Eight &a, const Eight &b) { return {a.low + b.low, a.high + b.high}; }

// The matrices of a block and what each lane takes of them.
template <uint32_t K>
struct Mixed {
    const float *matrices[K];
    const model::Lanes *weights;

    CLAQUE_INLINE Mixed(const float *palette, const model::LaneBlock &block, const model::Lanes *lane_weights)
        : weights(lane_weights)
    {
        for (uint32_t k = 0; k < K; ++k) matrices[k] = palette + aligned_matrix_floats * block.joints[k];
    }
    template <int Row>
    CLAQUE_INLINE Eight number(int column) const
    {
        const F4 first = spread<Row>(matrices[0] + 4 * column);
        if constexpr (K == 1) {
            return {first, first};
        } else {
            Eight out = first * lanes(weights[0]);
            out = out + spread<Row>(matrices[1] + 4 * column) * lanes(weights[1]);
            if constexpr (K > 2) out = out + spread<Row>(matrices[2] + 4 * column) * lanes(weights[2]);
            if constexpr (K > 3) out = out + spread<Row>(matrices[3] + 4 * column) * lanes(weights[3]);
            return out;
        }
    }
};

struct Vertices {
    Eight position[3], normal[3];
};

template <uint32_t K, bool OwnNormalMatrices, int Row>
CLAQUE_INLINE void skin_row(const Mixed<K> &m, const Mixed<K> &own, const model::Lanes *in, Vertices &out)
{
    const Eight x = m.template number<Row>(0), y = m.template number<Row>(1), z = m.template number<Row>(2);
    out.position[Row] = x * lanes(in[0]) + y * lanes(in[1]) + z * lanes(in[2]) + m.template number<Row>(3);
    if constexpr (OwnNormalMatrices)
        out.normal[Row] = own.template number<Row>(0) * lanes(in[3]) + own.template number<Row>(1) * lanes(in[4]) +
                          own.template number<Row>(2) * lanes(in[5]);
    else out.normal[Row] = x * lanes(in[3]) + y * lanes(in[4]) + z * lanes(in[5]);
}

template <int A, int B, int C, int D>
CLAQUE_INLINE F4 mix(F4 a, F4 b)
{
#if defined(__clang__)
    return __builtin_shufflevector(a, b, A, B, C + 4, D + 4);
#else
    return __builtin_shuffle(a, b, I4{A, B, C + 4, D + 4});
#endif
}

struct Reals {
    using Position = Real3;
    using Normal = Real3;
    Real3 *positions, *normals;

    CLAQUE_INLINE explicit Reals(const BlockRun &run) : positions(run.out_positions), normals(run.out_normals) {}

    CLAQUE_INLINE void write(const Vertices &v, Real3 *to_positions, Real3 *to_normals) const
    {
        store(&to_positions->x, v.position);
        store(&to_normals->x, v.normal);
    }

private:
    CLAQUE_INLINE static void store(float *out, const Eight v[3])
    {
        store(out, v[0].low, v[1].low, v[2].low);
        store(out + 12, v[0].high, v[1].high, v[2].high);
    }
    // x, y and z of four vertices to twelve numbers, vertex after vertex.
    CLAQUE_INLINE static void store(float *out, F4 x, F4 y, F4 z)
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

    CLAQUE_INLINE explicit Packed(const BlockRun &run)
        : positions(run.packed.positions), normals(run.packed.normals), packer_(run.packed.range)
    {
    }

    CLAQUE_INLINE void write(const Vertices &v, PackedPosition *to_positions, PackedNormal *to_normals) const
    {
        const Eight *p = v.position, *n = v.normal;
        packer_.positions(p[0].low, p[1].low, p[2].low, to_positions);
        packer_.positions(p[0].high, p[1].high, p[2].high, to_positions + 4);
        FourPacker::normals(n[0].low, n[1].low, n[2].low, to_normals);
        FourPacker::normals(n[0].high, n[1].high, n[2].high, to_normals + 4);
    }

private:
    FourPacker packer_;
};

template <uint32_t K, bool OwnNormalMatrices>
CLAQUE_INLINE Vertices skin_block(const BlockRun &run, const model::LaneBlock &block)
{
    const model::Lanes *in = run.lanes + block.first_lanes;
    const Mixed<K> m(run.palette, block, in + 6);
    const Mixed<K> own(OwnNormalMatrices ? run.normal_palette : run.palette, block, in + 6);
    Vertices out;
    skin_row<K, OwnNormalMatrices, 0>(m, own, in, out);
    skin_row<K, OwnNormalMatrices, 1>(m, own, in, out);
    skin_row<K, OwnNormalMatrices, 2>(m, own, in, out);
    return out;
}

}  // namespace

}  // namespace claque::skin

#define CLAQUE_BLOCKS
#define CLAQUE_BLOCKS_RUN run_vector_blocks
#include "lib/skin/blocks_run.h"
