// Four numbers at a time: the columns of the matrices are blended, then the vertex is sent through them. Stores of
// four overlap, each vertex overwriting what the one before it left in its fourth lane; the last stores three.
#include "lib/math/simd.h"
#include "lib/skin/kernel.h"

namespace claque::skin
{

namespace
{

using math::F4;

// K influences; 0 means any number, counted at run time.
template <uint32_t K>
struct Blended {
    F4 c[4];
    Blended(const math::Affine *palette, const uint16_t *joints, const float *weights, uint32_t influences, int columns)
    {
        const uint32_t count = K ? K : influences;
        const float *first = palette[joints[0]].c;
        for (int i = 0; i < columns; ++i) c[i] = math::load4(first + 3 * i);
        if (count == 1) return;
        const F4 w0 = math::splat(weights[0]);
        for (int i = 0; i < columns; ++i) c[i] = c[i] * w0;
        for (uint32_t k = 1; k < count; ++k) {
            const float *next = palette[joints[k]].c;
            const F4 w = math::splat(weights[k]);
            for (int i = 0; i < columns; ++i) c[i] = c[i] + math::load4(next + 3 * i) * w;
        }
    }
    F4 direction(const float *d) const
    {
        return c[0] * math::splat(d[0]) + c[1] * math::splat(d[1]) + c[2] * math::splat(d[2]);
    }
};

template <uint32_t K, bool OwnNormalMatrices>
void run_kernel(const Run &run)
{
    const uint32_t stride = K ? K : run.influences;
    const uint16_t *joints = run.joints;
    const float *weights = run.weights, *p = run.positions, *n = run.normals;
    float *out_p = run.out_positions, *out_n = run.out_normals;
    for (uint32_t v = 0; v < run.count; ++v) {
        const Blended<K> m(run.palette, joints, weights, stride, 4);
        const F4 position = m.direction(p) + m.c[3];
        F4 normal;
        if constexpr (OwnNormalMatrices) {
            normal = Blended<K>(run.normal_palette, joints, weights, stride, 3).direction(n);
        } else {
            normal = m.direction(n);
        }
        if (v + 1 < run.count) {
            math::store4(out_p, position);
            math::store4(out_n, normal);
        } else {
            math::store3(out_p, position);
            math::store3(out_n, normal);
        }
        joints += stride, weights += stride, p += 3, n += 3, out_p += 3, out_n += 3;
    }
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
