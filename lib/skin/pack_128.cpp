// Four vertices at a time with SSE2. Other processors use the loop of pack.cpp.
#include "lib/skin/pack_lanes.h"

namespace claque::skin
{

#ifdef __SSE2__

namespace
{

// Transposes four vertices of three floats into x, y and z.
struct Four {
    __m128 x, y, z;

    explicit Four(const float *p)
    {
        const __m128 a = _mm_loadu_ps(p), b = _mm_loadu_ps(p + 4), c = _mm_loadu_ps(p + 8);
        const __m128 bc = _mm_shuffle_ps(b, c, _MM_SHUFFLE(2, 1, 3, 2));  // x2 y2 x3 y3
        const __m128 ab = _mm_shuffle_ps(a, b, _MM_SHUFFLE(1, 0, 2, 1));  // y0 z0 y1 z1
        x = _mm_shuffle_ps(a, bc, _MM_SHUFFLE(2, 0, 3, 0));
        y = _mm_shuffle_ps(ab, bc, _MM_SHUFFLE(3, 1, 2, 0));
        z = _mm_shuffle_ps(ab, c, _MM_SHUFFLE(3, 0, 3, 1));
    }
};

}  // namespace

uint32_t pack_128(const PackJob &job)
{
    const uint32_t done = job.out_positions.count & ~3u;
    const FourPacker packer(job.range);
    for (uint32_t v = 0; v < done; v += 4) {
        const Four p(job.positions.data + 3 * size_t(v)), n(job.normals.data + 3 * size_t(v));
        packer.positions(p.x, p.y, p.z, job.out_positions.data + v);
        FourPacker::normals(n.x, n.y, n.z, job.out_normals.data + v);
    }
    return done;
}

#else

uint32_t pack_128(const PackJob &) { return 0; }

#endif

}  // namespace claque::skin
