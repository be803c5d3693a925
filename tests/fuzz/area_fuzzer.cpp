// Files of walkable areas: what is read has rings, triangles that fill them, and walls between its points.
#include <claque/trajectories.h>

#include <cmath>

#include "tests/fuzz/fuzzer.h"

namespace
{

using namespace fuzzing;

double doubled(const clq_area_info &info, uint32_t a, uint32_t b, uint32_t c)
{
    const double *p = info.points_m + 3 * size_t(a), *q = info.points_m + 3 * size_t(b),
                 *r = info.points_m + 3 * size_t(c);
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

void expect_filled(const clq_area_info &info)
{
    double sum = 0, largest = 1;
    for (uint32_t i = 0; i < 3 * info.triangle_count; ++i) ASSERT_LT(info.triangles[i], info.point_count);
    for (uint32_t t = 0; t < info.triangle_count; ++t) {
        const double area = doubled(info, info.triangles[3 * t], info.triangles[3 * t + 1], info.triangles[3 * t + 2]);
        sum += area / 2;
        largest = std::fmax(largest, std::fabs(area));
    }
    for (int k = 0; k < 2; ++k) largest = std::fmax(largest, std::pow(info.box_max_m[k] - info.box_min_m[k], 2));
    EXPECT_NEAR(sum, info.area_m2, 1e-9 * largest * (1 + info.triangle_count));
    for (uint32_t i = 0; i < 2 * info.wall_count; ++i) EXPECT_LT(info.walls[i], info.point_count);
    uint32_t polygon = 0;
    for (uint32_t i = 0; i < info.ring_count; ++i) {
        const clq_area_ring &ring = info.rings[i];
        EXPECT_GE(ring.point_count, 3u);
        EXPECT_LE(uint64_t(ring.first_point) + ring.point_count, info.point_count);
        EXPECT_EQ(ring.polygon, ring.hole ? polygon : i == 0 ? 0 : polygon + 1);
        polygon = ring.polygon;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    clq_context *context = new_context();
    clq_area *area = nullptr;
    if (done(clq_area_load_memory(context, bytes, size, nullptr, &area), {CLQ_FORMAT, CLQ_UNSUPPORTED, CLQ_LIMIT})) {
        clq_area_info info = clq_area_info_init();
        EXPECT_EQ(clq_area_get_info(area, &info), CLQ_OK);
        expect_filled(info);
        for (uint32_t i = 0; i < info.warning_count; ++i) EXPECT_STRNE(clq_area_get_warning(area, i), "");
    }
    clq_area_destroy(area);
    end(context);
    return 0;
}
