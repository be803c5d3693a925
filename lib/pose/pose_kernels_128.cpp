// Four joints at a time, one column at a time, for processors with 128-bit lanes: SSE2 on x86.
#include <cmath>

#include "lib/pose/pose_kernels.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#define CLAQUE_POSE_INLINE inline
#define CLAQUE_POSE_KERNEL
#include "lib/pose/pose_kernels_body.h"

namespace claque::pose
{

namespace
{

using math::F4;

struct Four {
    using V = F4;
    static constexpr uint32_t width = 4;
    static V load(const float *p) { return math::load4(p); }
    static void store(float *p, V v) { math::store4(p, v); }
    static V splat(float x) { return math::splat(x); }
#if defined(__SSE2__)
    static V load_shorts(const int16_t *p)
    {
        const __m128i v = _mm_loadl_epi64(reinterpret_cast<const __m128i *>(p));
        return _mm_cvtepi32_ps(_mm_srai_epi32(_mm_unpacklo_epi16(v, v), 16));
    }
    static V root(V v) { return _mm_sqrt_ps(v); }
    static V flipped(V v, V by) { return _mm_xor_ps(v, _mm_and_ps(_mm_cmplt_ps(by, _mm_setzero_ps()), splat(-0.0f))); }
#else
    static V load_shorts(const int16_t *p) { return V{float(p[0]), float(p[1]), float(p[2]), float(p[3])}; }
    static V root(V v) { return V{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])}; }
    static V flipped(V v, V by)
    {
        for (int i = 0; i < 4; ++i) v[i] = by[i] < 0 ? -v[i] : v[i];
        return v;
    }
#endif
    static void columns(V x, V y, V z, math::Columns *const *to, int k)
    {
        const V zero = splat(0);
        const V xy = __builtin_shufflevector(x, y, 0, 4, 1, 5), z0 = __builtin_shufflevector(z, zero, 0, 4, 1, 5);
        const V xy2 = __builtin_shufflevector(x, y, 2, 6, 3, 7), z2 = __builtin_shufflevector(z, zero, 2, 6, 3, 7);
        to[0]->c[k] = __builtin_shufflevector(xy, z0, 0, 1, 4, 5);
        to[1]->c[k] = __builtin_shufflevector(xy, z0, 2, 3, 6, 7);
        to[2]->c[k] = __builtin_shufflevector(xy2, z2, 0, 1, 4, 5);
        to[3]->c[k] = __builtin_shufflevector(xy2, z2, 2, 3, 6, 7);
    }
    static V transform(const math::Columns &a, V v)
    {
        const V x = __builtin_shufflevector(v, v, 0, 0, 0, 0), y = __builtin_shufflevector(v, v, 1, 1, 1, 1);
        return a.c[0] * x + a.c[1] * y + a.c[2] * __builtin_shufflevector(v, v, 2, 2, 2, 2);
    }
    static void product(const math::Columns &a, math::Columns &b)
    {
        b.c[0] = transform(a, b.c[0]);
        b.c[1] = transform(a, b.c[1]);
        b.c[2] = transform(a, b.c[2]);
        b.c[3] = transform(a, b.c[3]) + a.c[3];
    }
    // Each store's fourth lane is overwritten by the next store.
    static void product_out(const math::Columns &a, const float *b, float *out)
    {
        store(out, transform(a, load(b)));
        store(out + 3, transform(a, load(b + 3)));
        store(out + 6, transform(a, load(b + 6)));
        math::store3(out + 9, transform(a, V{b[9], b[10], b[11], 0}) + a.c[3]);
    }
};

}  // namespace

const PoseKernels pose_kernels_128 = pose_kernels_for<Four>;

}  // namespace claque::pose
