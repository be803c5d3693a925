// Two columns of a matrix, then two vertices at a time, for processors with AVX2: the steps of simd_128.cpp in the same
// order, without fused multiply-add. Only functions of this file are compiled for AVX2. So no function that the linker
// may share with other files contains AVX2 code.
#include "lib/math/simd.h"
#include "lib/skin/kernel.h"

#if defined(__x86_64__) || defined(__i386__)

#include <immintrin.h>

#define CLAQUE_AVX2 __attribute__((target("avx2")))
#define CLAQUE_AVX2_INLINE __attribute__((target("avx2"), always_inline)) inline

namespace claque::skin
{

namespace
{

// The columns of one blended matrix: x and y, z and t.
struct Blended {
    __m256 xy, zt;
};

CLAQUE_AVX2_INLINE void add(Blended &m, const float *matrix, float weight)
{
    const __m256 w = _mm256_set1_ps(weight);
    m.xy = _mm256_add_ps(m.xy, _mm256_mul_ps(_mm256_load_ps(matrix), w));
    m.zt = _mm256_add_ps(m.zt, _mm256_mul_ps(_mm256_load_ps(matrix + 8), w));
}

// K influences; K = 0 means `influences`, which is more than 1.
template <uint32_t K>
CLAQUE_AVX2_INLINE Blended blend(const float *palette, const uint16_t *joints, const float *weights,
                                 uint32_t influences)
{
    const float *first = palette + aligned_matrix_floats * joints[0];
    Blended m = {_mm256_load_ps(first), _mm256_load_ps(first + 8)};
    if constexpr (K == 1) return m;
    const __m256 w = _mm256_set1_ps(weights[0]);
    m.xy = _mm256_mul_ps(m.xy, w);
    m.zt = _mm256_mul_ps(m.zt, w);
    if constexpr (K == 0)
        for (uint32_t k = 1; k < influences; ++k) add(m, palette + aligned_matrix_floats * joints[k], weights[k]);
    if constexpr (K > 1) add(m, palette + aligned_matrix_floats * joints[1], weights[1]);
    if constexpr (K > 2) add(m, palette + aligned_matrix_floats * joints[2], weights[2]);
    if constexpr (K > 3) add(m, palette + aligned_matrix_floats * joints[3], weights[3]);
    return m;
}

// The columns of two matrices, the first vertex's in the lower half.
struct Pair {
    __m256 x, y, z, t;

    CLAQUE_AVX2_INLINE Pair(const Blended &a, const Blended &b)
        : x(_mm256_permute2f128_ps(a.xy, b.xy, 0x20)),
          y(_mm256_permute2f128_ps(a.xy, b.xy, 0x31)),
          z(_mm256_permute2f128_ps(a.zt, b.zt, 0x20)),
          t(_mm256_permute2f128_ps(a.zt, b.zt, 0x31))
    {
    }
};

// x * d[0] + y * d[1] + z * d[2] for the vectors at d and d + 3; reads one float after them.
CLAQUE_AVX2_INLINE __m256 direction(const Pair &m, const float *d)
{
    const __m256 v = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(d)), _mm_loadu_ps(d + 3), 1);
    const __m256 x = _mm256_mul_ps(m.x, _mm256_permute_ps(v, 0x00));
    const __m256 y = _mm256_mul_ps(m.y, _mm256_permute_ps(v, 0x55));
    const __m256 z = _mm256_mul_ps(m.z, _mm256_permute_ps(v, 0xaa));
    return _mm256_add_ps(_mm256_add_ps(x, y), z);
}

// The second store overwrites the fourth lane of the first; the next vertex overwrites the fourth lane of the second.
CLAQUE_AVX2_INLINE void store(float *out, __m256 v)
{
    _mm_storeu_ps(out, _mm256_castps256_ps128(v));
    _mm_storeu_ps(out + 3, _mm256_extractf128_ps(v, 1));
}

template <uint32_t K, bool OwnNormalMatrices>
CLAQUE_AVX2 void run_pairs(const Run run, size_t pairs)
{
    const size_t stride = K ? K : run.influences;
    for (size_t i = 0; i < pairs; ++i) {
        const size_t v = 2 * i;
        const uint16_t *ja = run.joints + v * stride;
        const float *wa = run.weights + v * stride;
        const uint16_t *jb = ja + stride;
        const float *wb = wa + stride;
        const uint32_t n = run.influences;
        const Pair m(blend<K>(run.palette, ja, wa, n), blend<K>(run.palette, jb, wb, n));
        const __m256 position = _mm256_add_ps(direction(m, run.positions + 3 * v), m.t);
        __m256 normal;
        if constexpr (OwnNormalMatrices)
            normal = direction(Pair(blend<K>(run.normal_palette, ja, wa, n), blend<K>(run.normal_palette, jb, wb, n)),
                               run.normals + 3 * v);
        else normal = direction(m, run.normals + 3 * v);
        store(run.out_positions + 3 * v, position);
        store(run.out_normals + 3 * v, normal);
    }
}

template <uint32_t K>
void choose(const Run &run, size_t pairs)
{
    run.normal_palette ? run_pairs<K, true>(run, pairs) : run_pairs<K, false>(run, pairs);
}

}  // namespace

void run_256(const Run &run)
{
    // At least one vertex is left for run_128: nothing after the last is read or written.
    const size_t pairs = run.count ? (run.count - 1) / 2 : 0;
    switch (run.influences) {
        case 1:
            choose<1>(run, pairs);
            break;
        case 2:
            choose<2>(run, pairs);
            break;
        case 3:
            choose<3>(run, pairs);
            break;
        case 4:
            choose<4>(run, pairs);
            break;
        default:
            choose<0>(run, pairs);
            break;
    }
    Run rest = run;
    const size_t done = 2 * pairs;
    rest.count = run.count - static_cast<uint32_t>(done);
    rest.advance(done);
    rest.out_positions += 3 * done;
    rest.out_normals += 3 * done;
    run_128(rest);
}

}  // namespace claque::skin

#else

namespace claque::skin
{

void run_256(const Run &run) { run_128(run); }

}  // namespace claque::skin

#endif
