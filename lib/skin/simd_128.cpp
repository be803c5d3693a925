// Four floats at a time: the columns of the matrices are blended, then the vertex is transformed. Stores of four
// overlap: each vertex overwrites the fourth lane of the one before it, and the last stores three.
#include "lib/math/simd.h"
#include "lib/skin/kernel.h"

#define CLAQUE_INLINE __attribute__((always_inline)) inline

namespace claque::skin
{

namespace
{

using math::F4;
typedef int I4 __attribute__((vector_size(16)));

CLAQUE_INLINE F4 column(const float *matrix, int k)
{
    return *static_cast<const F4 *>(__builtin_assume_aligned(matrix + 4 * k, 16));
}

// Broadcasts one element of a vector to all lanes; faster than loading each element separately.
template <int I>
CLAQUE_INLINE F4 lane(F4 v)
{
#if defined(__clang__)
    return __builtin_shufflevector(v, v, I, I, I, I);
#else
    return __builtin_shuffle(v, I4{I, I, I, I});
#endif
}

CLAQUE_INLINE F4 load3(const float *p) { return F4{p[0], p[1], p[2], 0}; }

// The columns of a blended matrix. Unrolled by hand, so that they stay in registers at any optimisation level.
struct Blended {
    F4 x, y, z, t;

    CLAQUE_INLINE explicit Blended(const float *m) : x(column(m, 0)), y(column(m, 1)), z(column(m, 2)), t(column(m, 3))
    {
    }
    CLAQUE_INLINE Blended(const float *m, F4 w)
        : x(column(m, 0) * w), y(column(m, 1) * w), z(column(m, 2) * w), t(column(m, 3) * w)
    {
    }
    CLAQUE_INLINE void add(const float *m, F4 w)
    {
        x = x + column(m, 0) * w;
        y = y + column(m, 1) * w;
        z = z + column(m, 2) * w;
        t = t + column(m, 3) * w;
    }
    CLAQUE_INLINE F4 direction(F4 d) const { return x * lane<0>(d) + y * lane<1>(d) + z * lane<2>(d); }
};

CLAQUE_INLINE const float *matrix(const float *palette, uint16_t joint)
{
    return palette + aligned_matrix_floats * joint;
}

// Loads the weights of K influences; it loads four floats where memory allows it.
template <uint32_t K, bool Last>
CLAQUE_INLINE F4 weights_of(const float *weights)
{
    if constexpr (K < 2) return F4{0, 0, 0, 0};
    else if constexpr (!Last || K == 4) return math::load4(weights);
    else if constexpr (K == 3) return load3(weights);
    else return F4{weights[0], weights[1], 0, 0};
}

// K influences; K = 0 means `influences`, which is more than 1.
template <uint32_t K>
CLAQUE_INLINE Blended blend(const float *palette, const uint16_t *joints, F4 w, const float *weights,
                            uint32_t influences)
{
    if constexpr (K == 1) return Blended(matrix(palette, joints[0]));
    if constexpr (K == 0) {
        Blended m(matrix(palette, joints[0]), math::splat(weights[0]));
        for (uint32_t k = 1; k < influences; ++k) m.add(matrix(palette, joints[k]), math::splat(weights[k]));
        return m;
    }
    Blended m(matrix(palette, joints[0]), lane<0>(w));
    if constexpr (K > 1) m.add(matrix(palette, joints[1]), lane<1>(w));
    if constexpr (K > 2) m.add(matrix(palette, joints[2]), lane<2>(w));
    if constexpr (K > 3) m.add(matrix(palette, joints[3]), lane<3>(w));
    return m;
}

// Skins one vertex. All but the last are followed by another, so loads may run over.
template <uint32_t K, bool OwnNormalMatrices, bool Last>
CLAQUE_INLINE void vertex(const Run &run, size_t v, F4 &position, F4 &normal)
{
    const uint32_t stride = K ? K : run.influences;
    const uint16_t *joints = run.joints + v * stride;
    const float *weights = run.weights + v * stride;
    const F4 p = Last ? load3(run.positions + 3 * v) : math::load4(run.positions + 3 * v);
    const F4 n = Last ? load3(run.normals + 3 * v) : math::load4(run.normals + 3 * v);
    const F4 w = weights_of<K, Last>(weights);
    const Blended m = blend<K>(run.palette, joints, w, weights, stride);
    position = m.direction(p) + m.t;
    if constexpr (OwnNormalMatrices) normal = blend<K>(run.normal_palette, joints, w, weights, stride).direction(n);
    else normal = m.direction(n);
}

template <uint32_t K, bool OwnNormalMatrices>
void run_kernel(const Run run)
{
    if (run.count == 0) return;
    F4 position, normal;
    const size_t last = run.count - 1;
    for (size_t v = 0; v < last; ++v) {
        vertex<K, OwnNormalMatrices, false>(run, v, position, normal);
        math::store4(run.out_positions + 3 * v, position);
        math::store4(run.out_normals + 3 * v, normal);
    }
    vertex<K, OwnNormalMatrices, true>(run, last, position, normal);
    math::store3(run.out_positions + 3 * last, position);
    math::store3(run.out_normals + 3 * last, normal);
}

template <uint32_t K>
void choose(const Run &run)
{
    run.normal_palette ? run_kernel<K, true>(run) : run_kernel<K, false>(run);
}

}  // namespace

void run_128(const Run &run)
{
    switch (run.influences) {
        case 1:
            return choose<1>(run);
        case 2:
            return choose<2>(run);
        case 3:
            return choose<3>(run);
        case 4:
            return choose<4>(run);
        default:
            return choose<0>(run);
    }
}

void blend_128(const SetRun &run)
{
    for (uint32_t s = 0; s < run.count; ++s) {
        const size_t at = size_t(s) * run.influences;
        const Blended m = blend<0>(run.palette, run.joints + at, F4(), run.weights + at, run.influences);
        float *out = run.out + aligned_matrix_floats * s;
        math::store4(out, m.x), math::store4(out + 4, m.y), math::store4(out + 8, m.z), math::store4(out + 12, m.t);
    }
}

void align_matrices(base::Span<const math::Affine> palette, float *out)
{
    for (uint32_t i = 0; i < palette.count; ++i, out += aligned_matrix_floats)
        for (int k = 0; k < 4; ++k) math::store4(out + 4 * k, math::load4(palette[i].c + 3 * k));
}

}  // namespace claque::skin
