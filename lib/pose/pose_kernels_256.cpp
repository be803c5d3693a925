// Eight joints at a time, two columns at a time, for processors with AVX2. Only functions of this file are compiled for
// AVX2. So no function that the linker may share with other files contains AVX2 code.
#include "lib/pose/pose_kernels.h"

#if defined(__x86_64__) || defined(__i386__)

#include <immintrin.h>

#define CLAQUE_POSE_INLINE __attribute__((target("avx2"), always_inline)) inline
#define CLAQUE_POSE_KERNEL __attribute__((target("avx2")))
#include "lib/pose/pose_kernels_body.h"

namespace claque::pose
{

namespace
{

typedef float F8 __attribute__((vector_size(32)));

struct Eight {
    using V = F8;
    static constexpr uint32_t width = 8;
    CLAQUE_POSE_INLINE static V load(const float *p) { return _mm256_loadu_ps(p); }
    CLAQUE_POSE_INLINE static void store(float *p, V v) { _mm256_storeu_ps(p, v); }
    CLAQUE_POSE_INLINE static V splat(float x) { return _mm256_set1_ps(x); }
    CLAQUE_POSE_INLINE static V load_shorts(const int16_t *p)
    {
        return _mm256_cvtepi32_ps(_mm256_cvtepi16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i *>(p))));
    }
    CLAQUE_POSE_INLINE static V root(V v) { return _mm256_sqrt_ps(v); }
    CLAQUE_POSE_INLINE static V flipped(V v, V by)
    {
        const V below = _mm256_cmp_ps(by, _mm256_setzero_ps(), _CMP_LT_OQ);
        return _mm256_xor_ps(v, _mm256_and_ps(below, _mm256_set1_ps(-0.0f)));
    }
    CLAQUE_POSE_INLINE static void pair(V v, math::Columns *low, math::Columns *high, int k)
    {
        _mm_store_ps(reinterpret_cast<float *>(&low->c[k]), _mm256_castps256_ps128(v));
        _mm_store_ps(reinterpret_cast<float *>(&high->c[k]), _mm256_extractf128_ps(v, 1));
    }
    CLAQUE_POSE_INLINE static void columns(V x, V y, V z, math::Columns *const *to, int k)
    {
        const V zero = _mm256_setzero_ps();
        const V xy = _mm256_unpacklo_ps(x, y), z0 = _mm256_unpacklo_ps(z, zero);
        const V xy2 = _mm256_unpackhi_ps(x, y), z2 = _mm256_unpackhi_ps(z, zero);
        pair(_mm256_shuffle_ps(xy, z0, 0x44), to[0], to[4], k);
        pair(_mm256_shuffle_ps(xy, z0, 0xee), to[1], to[5], k);
        pair(_mm256_shuffle_ps(xy2, z2, 0x44), to[2], to[6], k);
        pair(_mm256_shuffle_ps(xy2, z2, 0xee), to[3], to[7], k);
    }
    CLAQUE_POSE_INLINE static V twice(const math::F4 &column)
    {
        return _mm256_broadcast_ps(reinterpret_cast<const __m128 *>(&column));
    }
    // Transforms two columns of b.
    CLAQUE_POSE_INLINE static V transform(const math::Columns &a, V b)
    {
        const V x = _mm256_permute_ps(b, 0x00), y = _mm256_permute_ps(b, 0x55), z = _mm256_permute_ps(b, 0xaa);
        return twice(a.c[0]) * x + twice(a.c[1]) * y + twice(a.c[2]) * z;
    }
    // Adds the translation to the fourth column only.
    CLAQUE_POSE_INLINE static V moved(const math::Columns &a, V zt)
    {
        return _mm256_blend_ps(zt, zt + twice(a.c[3]), 0xf0);
    }
    CLAQUE_POSE_INLINE static void product(const math::Columns &a, math::Columns &b)
    {
        float *p = reinterpret_cast<float *>(&b);
        const V xy = transform(a, load(p)), zt = transform(a, load(p + 8));
        store(p, xy);
        store(p + 8, moved(a, zt));
    }
    CLAQUE_POSE_INLINE static V two(const float *low, const float *high)
    {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1);
    }
    // The last column's load begins one float early, so that it ends with the matrix. Each store's fourth lane is
    // overwritten by the next store.
    CLAQUE_POSE_INLINE static void product_out(const math::Columns &a, const float *b, float *out)
    {
        const V xy = transform(a, two(b, b + 3));
        const V last = _mm256_castps128_ps256(_mm_loadu_ps(b + 8));
        const V t = _mm256_permute_ps(last, 0x39);
        const V zt = moved(a, transform(a, _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(b + 6)),
                                                                _mm256_castps256_ps128(t), 1)));
        _mm_storeu_ps(out, _mm256_castps256_ps128(xy));
        _mm_storeu_ps(out + 3, _mm256_extractf128_ps(xy, 1));
        _mm_storeu_ps(out + 6, _mm256_castps256_ps128(zt));
        math::store3(out + 9, _mm256_extractf128_ps(zt, 1));
    }
};

}  // namespace

const PoseKernels pose_kernels_256 = pose_kernels_for<Eight>;

}  // namespace claque::pose

#else

namespace claque::pose
{

const PoseKernels pose_kernels_256 = pose_kernels_128;

}  // namespace claque::pose

#endif
