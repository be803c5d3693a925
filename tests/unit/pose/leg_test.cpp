// The two-bone leg in double precision: what it may change, and where it has to get.
#include "lib/pose/leg.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

using namespace claque;

namespace
{

constexpr glm::vec3 hip(0.1f, 0.95f, 0), knee(0.1f, 0.5f, 0.12f), ankle(0.1f, 0.08f, -0.02f);

math::Columns at(const glm::vec3 &place)
{
    math::Columns out;
    out.c[0] = math::F4{1, 0, 0, 0}, out.c[1] = math::F4{0, 1, 0, 0}, out.c[2] = math::F4{0, 0, 1, 0};
    out.c[3] = math::F4{place.x, place.y, place.z, 1};
    return out;
}

pose::Leg leg()
{
    pose::Leg out;
    out.thigh = 0, out.shin = 1, out.foot = 2;
    out.thigh_nodes = {0}, out.shin_nodes = {1}, out.foot_nodes = {2};
    out.ankle = ankle - knee;
    out.ball = glm::vec3(0, -0.08f, 0.14f), out.heel = glm::vec3(0, -0.08f, -0.06f);
    out.max_shift = 0.4f;
    return out;
}

TEST(MovedFoot, KeepsTheLengthsOfThighAndShinAndBendsTheKneeToItsSide)
{
    const pose::Leg one = leg();
    const double thigh = glm::length(glm::dvec3(knee - hip)), shin = glm::length(glm::dvec3(ankle - knee));
    for (const glm::vec3 &shift : {glm::vec3(0, 0, 0.2f), glm::vec3(0, 0, -0.2f), glm::vec3(0.15f, 0.1f, 0.05f),
                                   glm::vec3(-0.1f, 0.3f, 0.1f), glm::vec3(0, 0.02f, 0)}) {
        math::Columns globals[3] = {at(hip), at(knee), at(ankle)};
        pose::FootTarget target;
        target.leg = &one;
        target.x = shift.x, target.y = shift.y, target.z = shift.z;
        pose::move_foot(target, globals);
        const glm::dvec3 to_hip(pose::point_of(globals[0], glm::vec3(0))),
            to_knee(pose::point_of(globals[1], glm::vec3(0)));
        const glm::dvec3 to_ankle(pose::point_of(globals[1], one.ankle)),
            to_foot(pose::point_of(globals[2], glm::vec3(0)));
        EXPECT_EQ(to_hip, glm::dvec3(hip));
        EXPECT_NEAR(glm::length(to_foot - glm::dvec3(ankle + shift)), 0, 1e-6);
        EXPECT_NEAR(glm::length(to_foot - to_ankle), 0, 1e-6) << "the foot stays at the shin";
        EXPECT_NEAR(glm::length(to_knee - to_hip), thigh, 1e-6);
        EXPECT_NEAR(glm::length(to_ankle - to_knee), shin, 1e-6);
        const glm::dvec3 from_thigh(pose::point_of(globals[0], knee - hip));
        EXPECT_NEAR(glm::length(from_thigh - to_knee), 0, 1e-6) << "the thigh ends at the knee";
        const glm::dvec3 along = glm::normalize(to_ankle - to_hip);
        const glm::dvec3 side = to_knee - to_hip - along * glm::dot(to_knee - to_hip, along);
        EXPECT_GT(side.z, 0.05) << "forward, where it was bent";
    }
}

}  // namespace
