// Four numbers at a time: the columns of the matrices are blended, then the vertex is sent through them. Stores of
// four overlap, each vertex overwriting what the one before it left in its fourth lane; the last stores three.
#include "lib/math/simd.h"
#include "lib/skin/kernel.h"

namespace claque::skin
{

namespace
{

using math::F4;

// Columns of a blended matrix. Written out, not looped over, so that they stay in registers at any optimisation.
struct Blended {
    F4 x, y, z, t;

    Blended(const math::Affine &a)
        : x(math::load4(a.c)), y(math::load4(a.c + 3)), z(math::load4(a.c + 6)), t(math::load4(a.c + 9))
    {
    }
    void weigh(float weight)
    {
        const F4 w = math::splat(weight);
        x = x * w, y = y * w, z = z * w, t = t * w;
    }
    void add(const math::Affine &a, float weight)
    {
        const F4 w = math::splat(weight);
        x = x + math::load4(a.c) * w;
        y = y + math::load4(a.c + 3) * w;
        z = z + math::load4(a.c + 6) * w;
        t = t + math::load4(a.c + 9) * w;
    }
    F4 direction(const float *d) const { return x * math::splat(d[0]) + y * math::splat(d[1]) + z * math::splat(d[2]); }
};

// K influences; 0 means `influences`, which is more than 1.
template <uint32_t K>
__attribute__((always_inline)) inline Blended blend(const math::Affine *palette, const uint16_t *joints,
                                                    const float *weights, uint32_t influences)
{
    Blended m(palette[joints[0]]);
    if constexpr (K == 1) return m;
    m.weigh(weights[0]);
    if constexpr (K == 0)
        for (uint32_t k = 1; k < influences; ++k) m.add(palette[joints[k]], weights[k]);
    if constexpr (K > 1) m.add(palette[joints[1]], weights[1]);
    if constexpr (K > 2) m.add(palette[joints[2]], weights[2]);
    if constexpr (K > 3) m.add(palette[joints[3]], weights[3]);
    return m;
}

// One vertex; all is by value, so that what is stored cannot be what is read next.
template <uint32_t K, bool OwnNormalMatrices>
__attribute__((always_inline)) inline void vertex(const Run &run, size_t v, F4 &position, F4 &normal)
{
    const uint32_t stride = K ? K : run.influences;
    const uint16_t *joints = run.joints + v * stride;
    const float *weights = run.weights + v * stride, *n = run.normals + 3 * v;
    const Blended m = blend<K>(run.palette, joints, weights, stride);
    position = m.direction(run.positions + 3 * v) + m.t;
    if constexpr (OwnNormalMatrices) {
        normal = blend<K>(run.normal_palette, joints, weights, stride).direction(n);
    } else {
        normal = m.direction(n);
    }
}

template <uint32_t K, bool OwnNormalMatrices>
void run_kernel(const Run run)
{
    if (run.count == 0) return;
    F4 position, normal;
    const size_t last = run.count - 1;
    for (size_t v = 0; v < last; ++v) {
        vertex<K, OwnNormalMatrices>(run, v, position, normal);
        math::store4(run.out_positions + 3 * v, position);
        math::store4(run.out_normals + 3 * v, normal);
    }
    vertex<K, OwnNormalMatrices>(run, last, position, normal);
    math::store3(run.out_positions + 3 * last, position);
    math::store3(run.out_normals + 3 * last, normal);
}

template <uint32_t K>
void choose(const Run &run)
{
    run.normal_palette ? run_kernel<K, true>(run) : run_kernel<K, false>(run);
}

}  // namespace

void run_vector(const Run &run)
{
    switch (run.influences) {
        case 1:
            choose<1>(run);
            break;
        case 2:
            choose<2>(run);
            break;
        case 3:
            choose<3>(run);
            break;
        case 4:
            choose<4>(run);
            break;
        default:
            choose<0>(run);
            break;
    }
}

}  // namespace claque::skin
