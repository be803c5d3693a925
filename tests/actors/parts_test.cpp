// Part culling (S0 4.2 phase 3): culled parts are outside the frustum, and visible parts are never culled.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/actors/robot.h"

using namespace actors;

namespace
{

struct Corner {
    double x, y, z, w;
};

Corner clip_of(const float (&projection)[16], const float (&model_view)[16], const float *p)
{
    double eye[4], out[4];
    for (int r = 0; r < 4; ++r)
        eye[r] = double(model_view[r]) * p[0] + double(model_view[4 + r]) * p[1] + double(model_view[8 + r]) * p[2] +
                 double(model_view[12 + r]);
    for (int r = 0; r < 4; ++r)
        out[r] = double(projection[r]) * eye[0] + double(projection[4 + r]) * eye[1] +
                 double(projection[8 + r]) * eye[2] + double(projection[12 + r]) * eye[3];
    return {out[0], out[1], out[2], out[3]};
}

// The frustum planes that have all corners of a triangle outside.
uint32_t outside(const Corner (&c)[3])
{
    uint32_t all = 63;
    for (const Corner &k : c) {
        const uint32_t one = (k.x < -k.w) | (k.x > k.w) << 1 | (k.y < -k.w) << 2 | (k.y > k.w) << 3 |
                             (k.z < -k.w) << 4 | (k.z > k.w) << 5;
        all &= one;
    }
    return all;
}

// The part of a level to which an index of the fused range belongs.
uint32_t part_of(const model::Level &level, const model::Surface &surface, uint32_t offset)
{
    const uint32_t parts = static_cast<uint32_t>(level.parts.size());
    const uint32_t *firsts = surface.part_offsets.data() + surface.part_offsets.size() - (parts + 1);
    uint32_t part = 0;
    while (firsts[part + 1] <= offset) ++part;
    return part;
}

}  // namespace

TEST(Parts, OverAThousandCamerasNoVisibleTriangleIsLeftOut)
{
    World world;
    for (uint32_t i = 0; i < 12; ++i)
        world.add({4 * random_unit(1, i) - 2, 0, 4 * random_unit(2, i) - 2}, float(6 * random_unit(3, i)), i);
    world.look({0, 1, 5}, {0, 1, 0});
    uint64_t left_out = 0, kept = 0, checked = 0;
    for (uint32_t k = 0; k < 1000; ++k) {
        const glm::dvec3 eye(6 * random_unit(4, k) - 3, 3 * random_unit(5, k), 6 * random_unit(6, k) - 3);
        const glm::dvec3 target =
            eye + glm::dvec3(random_unit(7, k) - 0.5, 0.6 * random_unit(8, k) - 0.3, random_unit(9, k) - 0.5);
        world.views[0]->camera =
            frame::look_at(eye, target, glm::vec3(0, 1, 0), 0.3f + 1.2f * float(random_unit(10, k)), 1.3f, 0.05f, 50);
        world.update(0.01 * k);
        std::vector<bool> listed(12, false);
        for (const draw::Item &item : world.views[0]->list.items) {
            listed[item.actor_index] = true;
            const model::Level &level = item.tmpl->levels[item.level];
            ASSERT_GT(level.parts.size(), 1u);
            ASSERT_NE(item.parts, 0u) << "an actor without drawn parts is not listed";
            for (uint32_t p = 0; p < level.parts.size(); ++p) ++(item.parts >> p & 1 ? kept : left_out);
            for (const model::Surface &surface : level.surfaces)
                for (uint32_t i = 0; i < surface.fused.count; i += 3) {
                    if (item.parts >> part_of(level, surface, i) & 1) continue;
                    Corner corners[3];
                    for (uint32_t c = 0; c < 3; ++c)
                        corners[c] = clip_of(world.views[0]->list.projection, item.model_view,
                                             item.vertices.positions + 3 * level.indices[surface.fused.first + i + c]);
                    ASSERT_NE(outside(corners), 0u) << "camera " << k << " actor " << item.actor_index;
                    ++checked;
                }
        }
    }
    EXPECT_GT(left_out, 5000u);
    EXPECT_GT(kept, 5000u);
    EXPECT_GT(checked, 50000u);
}

TEST(Parts, AnActorWhollyInsideIsNotTestedByParts)
{
    World world;
    world.add({0, 0, -10});
    world.look({0, 1, 0}, {0, 1, -10});
    world.update(0);
    EXPECT_EQ(world.frame.stats().crossing, 0u);
    EXPECT_EQ(world.frame.stats().spheres_built, 0u);
    world.views[0]->camera = frame::look_at({0, 1, 0}, {4.5, 1, -10}, glm::vec3(0, 1, 0), 0.6f, 1.3f, 0.1f, 100);
    world.update(0);
    EXPECT_EQ(world.frame.stats().crossing, 1u);
    EXPECT_GT(world.frame.stats().spheres_built, 8u);
}
