// The two-bone leg in double precision: what it may change, and where it has to get.
#include "lib/pose/leg.h"

#include <algorithm>

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
    out.sole = {{out.heel, -0.2f, 0}, {out.ball, 0, 0}, {glm::vec3(0, -0.08f, 0.2f), 0.06f, 0}};
    out.first_of_toes = 3;
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

// Toes down for angles above 0.
math::Columns pitched(const glm::vec3 &place, float angle)
{
    math::Columns out = at(place);
    out.c[1] = math::F4{0, std::cos(angle), std::sin(angle), 0},
    out.c[2] = math::F4{0, -std::sin(angle), std::cos(angle), 0};
    return out;
}

const pose::SolePoint &lowest(const pose::Leg &leg, const math::Columns &foot)
{
    return *std::min_element(leg.sole.begin(), leg.sole.end(), [&](const auto &a, const auto &b) {
        return pose::point_of(foot, a.at).y < pose::point_of(foot, b.at).y;
    });
}

// Whichever point of the sole is the lowest lies where it would under the flat foot.
TEST(MovedFoot, RollsOverItsSoleAndNeitherSlipsNorTurns)
{
    const pose::Leg one = leg();
    const double turn = 0.3, x = 0.12, z = 0.05;
    int seen[3] = {0, 0, 0};
    for (float angle = -0.8f; angle < 0.8f; angle += 0.05f) {
        math::Columns globals[3] = {at(hip), at(knee), pitched(ankle, angle)};
        pose::FootTarget target;
        target.leg = &one, target.planted = true, target.ground = 1;
        target.x = float(x), target.z = float(z), target.turn_rad = float(turn);
        pose::move_foot(target, globals);
        const pose::SolePoint &point = lowest(one, globals[2]);
        ++seen[&point - one.sole.data()];
        const glm::dvec3 found(pose::point_of(globals[2], point.at));
        EXPECT_NEAR(found.x, x + double(point.ahead) * std::sin(turn), 1e-6) << angle;
        EXPECT_NEAR(found.y, 0, 1e-6) << angle;
        EXPECT_NEAR(found.z, z + double(point.ahead) * std::cos(turn), 1e-6) << angle;
        const pose::Print print = pose::print_of(one, globals);
        EXPECT_NEAR(print.x, x, 1e-6);
        EXPECT_NEAR(print.z, z, 1e-6);
        EXPECT_NEAR(print.low, 0, 1e-6);
        EXPECT_NEAR(std::atan2(print.ahead_x, print.ahead_z), turn, 1e-6);
    }
    EXPECT_GT(seen[0], 5);
    EXPECT_GT(seen[2], 5);
}

TEST(MovedFoot, StaysOverTheHeightThatItHasToClear)
{
    const pose::Leg one = leg();
    for (const float high : {-0.03f, 0.0f, 0.01f, 0.3f}) {
        math::Columns globals[3] = {at(hip), at(knee), at(ankle + glm::vec3(0, high, 0))};
        pose::FootTarget target;
        target.leg = &one, target.clear = 0.02f;
        pose::move_foot(target, globals);
        const float low = pose::point_of(globals[2], lowest(one, globals[2]).at).y;
        EXPECT_GE(low, 0.02f);
        EXPECT_NEAR(low, std::max(0.02f, high), 0.003f) << high;
    }
}

}  // namespace
