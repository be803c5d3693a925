// One float at a time: the reference of the other sets, and the implementation for CLAQUE_SIMD=scalar.
#include <cmath>

#include "lib/pose/pose_kernels.h"

#define CLAQUE_POSE_INLINE inline
#define CLAQUE_POSE_KERNEL
#include "lib/pose/pose_kernels_body.h"

namespace claque::pose
{

namespace
{

struct One {
    using V = float;
    static constexpr uint32_t width = 1;
    static V load(const float *p) { return *p; }
    static void store(float *p, V v) { *p = v; }
    static V load_shorts(const int16_t *p) { return static_cast<float>(*p); }
    static V splat(float x) { return x; }
    static V root(V v) { return std::sqrt(v); }
    static V flipped(V v, V by) { return by < 0 ? -v : v; }
    static void columns(V x, V y, V z, math::Columns *const *to, int k) { to[0]->c[k] = math::F4{x, y, z, 0}; }
    static float row(const math::Columns &a, int r, const float *v)
    {
        return a.c[0][r] * v[0] + a.c[1][r] * v[1] + a.c[2][r] * v[2];
    }
    static void product(const math::Columns &a, math::Columns &b)
    {
        for (int k = 0; k < 4; ++k) {
            float v[4];
            std::memcpy(v, &b.c[k], sizeof v);
            for (int r = 0; r < 4; ++r) b.c[k][r] = k == 3 ? row(a, r, v) + a.c[3][r] : row(a, r, v);
        }
    }
    static void product_out(const math::Columns &a, const float *b, float *out)
    {
        for (int k = 0; k < 4; ++k)
            for (int r = 0; r < 3; ++r) out[3 * k + r] = k == 3 ? row(a, r, b + 9) + a.c[3][r] : row(a, r, b + 3 * k);
    }
};

}  // namespace

const PoseKernels pose_kernels_scalar = pose_kernels_for<One>;

}  // namespace claque::pose
