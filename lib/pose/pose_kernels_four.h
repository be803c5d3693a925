// Four joints at a time, one column at a time: the lane type of pose_kernels_128.cpp and pose_kernels_128_avx.cpp, each
// of which includes it once after pose_kernels_body.h.
#include <cmath>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace claque::pose
{

namespace
{

using math::F4;

struct Four {
    using V = F4;
    static constexpr uint32_t width = 4;
    CLAQUE_POSE_INLINE static V load(const float *p) { return math::load4(p); }
    CLAQUE_POSE_INLINE static void store(float *p, V v) { math::store4(p, v); }
    CLAQUE_POSE_INLINE static V splat(float x) { return math::splat(x); }
#if defined(__SSE2__)
    CLAQUE_POSE_INLINE static V load_shorts(const int16_t *p)
    {
        const __m128i v = _mm_loadl_epi64(reinterpret_cast<const __m128i *>(p));
        return _mm_cvtepi32_ps(_mm_srai_epi32(_mm_unpacklo_epi16(v, v), 16));
    }
    CLAQUE_POSE_INLINE static V root(V v) { return _mm_sqrt_ps(v); }
    CLAQUE_POSE_INLINE static V flipped(V v, V by)
    {
        return _mm_xor_ps(v, _mm_and_ps(_mm_cmplt_ps(by, _mm_setzero_ps()), splat(-0.0f)));
    }
#else
    CLAQUE_POSE_INLINE static V load_shorts(const int16_t *p)
    {
        return V{float(p[0]), float(p[1]), float(p[2]), float(p[3])};
    }
    CLAQUE_POSE_INLINE static V root(V v)
    {
        return V{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
    }
    CLAQUE_POSE_INLINE static V flipped(V v, V by)
    {
        for (int i = 0; i < 4; ++i) v[i] = by[i] < 0 ? -v[i] : v[i];
        return v;
    }
#endif
    CLAQUE_POSE_INLINE static void columns(V x, V y, V z, math::Columns *const *to, int k)
    {
        const V zero = splat(0);
        const V xy = __builtin_shufflevector(x, y, 0, 4, 1, 5), z0 = __builtin_shufflevector(z, zero, 0, 4, 1, 5);
        const V xy2 = __builtin_shufflevector(x, y, 2, 6, 3, 7), z2 = __builtin_shufflevector(z, zero, 2, 6, 3, 7);
        to[0]->c[k] = __builtin_shufflevector(xy, z0, 0, 1, 4, 5);
        to[1]->c[k] = __builtin_shufflevector(xy, z0, 2, 3, 6, 7);
        to[2]->c[k] = __builtin_shufflevector(xy2, z2, 0, 1, 4, 5);
        to[3]->c[k] = __builtin_shufflevector(xy2, z2, 2, 3, 6, 7);
    }
#ifdef CLAQUE_POSE_BROADCAST
    CLAQUE_POSE_INLINE static V element(const float *v, int k) { return _mm_broadcast_ss(v + k); }
#else
    CLAQUE_POSE_INLINE static V element(const float *v, int k) { return splat(v[k]); }
#endif
    CLAQUE_POSE_INLINE static V transform(const math::Columns &a, const float *v)
    {
        return a.c[0] * element(v, 0) + a.c[1] * element(v, 1) + a.c[2] * element(v, 2);
    }
    CLAQUE_POSE_INLINE static void product(const math::Columns &a, math::Columns &b)
    {
        float *p = reinterpret_cast<float *>(&b);
        const V x = transform(a, p), y = transform(a, p + 4), z = transform(a, p + 8), t = transform(a, p + 12);
        store(p, x), store(p + 4, y), store(p + 8, z), store(p + 12, t + a.c[3]);
    }
    CLAQUE_POSE_INLINE static void product_out(const math::Columns &a, const float *b, float *out)
    {
        const V x = transform(a, b), y = transform(a, b + 3), z = transform(a, b + 6), t = transform(a, b + 9) + a.c[3];
        const V xy = __builtin_shufflevector(x, y, 2, 2, 4, 4), zt = __builtin_shufflevector(z, t, 2, 2, 4, 4);
        store(out, __builtin_shufflevector(x, xy, 0, 1, 4, 6));
        store(out + 4, __builtin_shufflevector(y, z, 1, 2, 4, 5));
        store(out + 8, __builtin_shufflevector(zt, t, 0, 2, 5, 6));
    }
};

}  // namespace

}  // namespace claque::pose
