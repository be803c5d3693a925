// The steps of pose_kernels.h for a lane type L, included once by each file that defines a set. CLAQUE_POSE_INLINE sets
// the attributes for which functions are compiled. The files share no function, so no wide code runs on a processor
// without it.
//   L::V                        `L::width` floats
//   L::load, store              of such floats; L::load_shorts widens them
//   L::splat, root              one float to all lanes; the square root of each
//   L::flipped(v, by)           -v where `by` is below 0, else v
//   L::columns(x, y, z, to, k)  (x, y, z, 0) of each lane to to[lane]->c[k]
//   L::product, product_out     of two matrices
#include <cstring>

namespace claque::pose
{

namespace
{

constexpr uint32_t lanes = model::motion_lanes;

template <class L>
struct Rotations {
    typename L::V x, y, z, w;
};

template <class L>
CLAQUE_POSE_INLINE Rotations<L> load(const float *p)
{
    return {L::load(p), L::load(p + lanes), L::load(p + 2 * lanes), L::load(p + 3 * lanes)};
}

template <class L>
CLAQUE_POSE_INLINE void store(float *p, const Rotations<L> &q)
{
    L::store(p, q.x), L::store(p + lanes, q.y), L::store(p + 2 * lanes, q.z), L::store(p + 3 * lanes, q.w);
}

template <class L>
CLAQUE_POSE_INLINE typename L::V dot(const Rotations<L> &a, const Rotations<L> &b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

template <class L>
CLAQUE_POSE_INLINE Rotations<L> times(const Rotations<L> &q, typename L::V f)
{
    return {q.x * f, q.y * f, q.z * f, q.w * f};
}

template <class L>
CLAQUE_POSE_INLINE Rotations<L> unit(const Rotations<L> &q)
{
    return times<L>(q, L::splat(1) / L::root(dot<L>(q, q)));
}

template <class L>
CLAQUE_POSE_INLINE Rotations<L> product(const Rotations<L> &a, const Rotations<L> &b)
{
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

template <class L>
CLAQUE_POSE_INLINE typename L::V weight_of(const JointWeights &weights, uint32_t joint)
{
    const typename L::V all = L::splat(weights.all);
    return weights.by_joint ? all * L::load(weights.by_joint + joint) : all;
}

template <class L>
CLAQUE_POSE_KERNEL void sample(const RotationRows &rows, float *out)
{
    const typename L::V part = L::splat(rows.part);
    for (uint32_t b = 0; b < rows.block_count; ++b, out += model::block_numbers) {
        const model::MotionBlock &block = rows.blocks[b];
        if (block.first == model::none) {
            std::memcpy(out, rows.rest + size_t(model::block_numbers) * b, model::block_numbers * sizeof(float));
            continue;
        }
        const int16_t *from = rows.numbers + block.first + size_t(block.stride) * rows.row;
        const int16_t *to = from + block.stride;
        for (uint32_t i = 0; i < model::block_numbers; i += L::width) {
            const typename L::V a = L::load_shorts(from + i);
            L::store(out + i, a + part * (L::load_shorts(to + i) - a));
        }
    }
}

template <class L>
CLAQUE_POSE_KERNEL void replace(float *pose, const float *other, const JointWeights &weights, uint32_t block_count)
{
    for (uint32_t b = 0; b < block_count; ++b, pose += model::block_numbers, other += model::block_numbers)
        for (uint32_t i = 0; i < lanes; i += L::width) {
            const Rotations<L> from = unit<L>(load<L>(pose + i)), to = unit<L>(load<L>(other + i));
            const typename L::V weight = weight_of<L>(weights, lanes * b + i);
            const typename L::V q = L::flipped(weight, dot<L>(from, to)), p = L::splat(1) - weight;
            store<L>(pose + i,
                     {p * from.x + q * to.x, p * from.y + q * to.y, p * from.z + q * to.z, p * from.w + q * to.w});
        }
}

template <class L>
CLAQUE_POSE_KERNEL void add(float *pose, const float *other, const float *reference, const JointWeights &weights,
                            uint32_t block_count)
{
    for (uint32_t b = 0; b < block_count; ++b)
        for (uint32_t i = 0; i < lanes; i += L::width) {
            const size_t at = size_t(model::block_numbers) * b + i;
            Rotations<L> back = unit<L>(load<L>(reference + at));
            back = {-back.x, -back.y, -back.z, back.w};
            Rotations<L> turn = product<L>(back, unit<L>(load<L>(other + at)));
            const typename L::V weight = weight_of<L>(weights, lanes * b + i);
            turn = times<L>(turn, L::flipped(weight, turn.w));
            turn.w = turn.w + (L::splat(1) - weight);
            store<L>(pose + at, product<L>(unit<L>(load<L>(pose + at)), turn));
        }
}

// The matrix of a quaternion of any length but 0: 2 / length^2 replaces the factor 2 of a unit quaternion.
template <class L>
CLAQUE_POSE_INLINE void place_lanes(const float *rotations, const float *scales, math::Columns *const *to)
{
    const Rotations<L> q = load<L>(rotations);
    const typename L::V s = L::splat(2) / dot<L>(q, q), one = L::splat(1);
    const typename L::V x = q.x * s, y = q.y * s, z = q.z * s;
    const typename L::V xx = x * q.x, yy = y * q.y, zz = z * q.z, xy = x * q.y, xz = x * q.z, yz = y * q.z;
    const typename L::V wx = x * q.w, wy = y * q.w, wz = z * q.w;
    const typename L::V sx = L::load(scales), sy = L::load(scales + lanes), sz = L::load(scales + 2 * lanes);
    L::columns((one - (yy + zz)) * sx, (xy + wz) * sx, (xz - wy) * sx, to, 0);
    L::columns((xy - wz) * sy, (one - (xx + zz)) * sy, (yz + wx) * sy, to, 1);
    L::columns((xz + wy) * sz, (yz - wx) * sz, (one - (xx + yy)) * sz, to, 2);
}

template <class L>
CLAQUE_POSE_KERNEL void local_matrices(const float *rotations, const JointTransforms &places, math::Columns *out)
{
    math::Columns ignored;
    const uint32_t *nodes = places.nodes;
    const float *offsets = places.offsets, *scales = places.scales;
    for (uint32_t b = 0; b < places.block_count; ++b) {
        math::Columns *to[lanes];
        for (uint32_t i = 0; i < lanes; ++i) {
            to[i] = nodes[i] == model::none ? &ignored : out + nodes[i];
            std::memcpy(&to[i]->c[3], offsets + 4 * i, 4 * sizeof(float));
        }
        for (uint32_t i = 0; i < lanes; i += L::width) place_lanes<L>(rotations + i, scales + i, to + i);
        rotations += model::block_numbers, scales += 3 * lanes, nodes += lanes, offsets += 4 * lanes;
    }
}

template <class L>
CLAQUE_POSE_KERNEL void local_to_model(const uint32_t *parents, const uint32_t *nodes, uint32_t count,
                                       math::Columns *columns)
{
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t node = nodes ? nodes[i] : i, parent = parents[node];
        if (parent != model::none) L::product(columns[parent], columns[node]);
    }
}

template <class L>
CLAQUE_POSE_KERNEL void fill_palette(const model::PaletteEntry *entries, const uint32_t *chosen, uint32_t count,
                                     const math::Columns *columns, math::Affine *out)
{
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t entry = chosen ? chosen[i] : i;
        L::product_out(columns[entries[entry].node], entries[entry].inverse_bind.c, out[entry].c);
    }
}

template <class L>
constexpr PoseKernels pose_kernels_for = {sample<L>,         replace<L>,        add<L>,
                                          local_matrices<L>, local_to_model<L>, fill_palette<L>};

}  // namespace

}  // namespace claque::pose
