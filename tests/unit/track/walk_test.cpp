// People on tracks walk: their feet stand still while they carry weight, they face forward and turn slowly.
#include <cmath>

#include <gtest/gtest.h>

#include "lib/math/trig.h"
#include "tests/unit/track/feet.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

double between(double a, double b)
{
    const double turn = 2 * math::pi, d = b - a;
    return std::fabs(d - turn * std::floor(d / turn + 0.5));
}

class Walk : public testing::TestWithParam<const char *>
{
};

}  // namespace

TEST_P(Walk, FeetThatCarryWeightSlideByLessThanViewersNotice)
{
    test::Soles soles(test::locomotion_of(GetParam()));
    for (const test::Way &way : test::ways()) {
        const auto track = test::track_of(way.points, GetParam());
        const test::FootDrift drift = test::drift_of(soles, *track, 0.02);
        EXPECT_LT(drift.max(), 0.020) << way.name;
        EXPECT_GT(drift.each.size(), 10u) << way.name;
        EXPECT_LT(test::lift_of(soles, *track, 0.05), 0.020) << way.name;
    }
}

INSTANTIATE_TEST_SUITE_P(People, Walk, testing::Values("citizen", "patrician", "plebeian", "decurion"),
                         [](const auto &info) { return std::string(info.param); });

TEST(WalkMeasure, SeesFeetSlideWhereTheLegsAreNotHeld)
{
    test::Soles soles(test::locomotion_of("citizen"));
    for (const test::Way &way : test::ways()) {
        if (std::string(way.name) != "a circle of 1 m") continue;
        const auto track = test::track_of(way.points);
        EXPECT_GT(test::drift_of(soles, *track, 0.02, false).max(), 0.063);
    }
}

TEST(WalkingPeople, HaveAFootOnTheGroundUnlessTheyRun)
{
    for (const test::Way &way : test::ways()) {
        const auto track = test::track_of(way.points);
        int in_the_air = 0, count = 0;
        for (double t = 0; t < track->length_s; t += 0.02, ++count) {
            const track::State state = track::state_at(*track, t);
            if (state.gait > 1.05f) continue;
            const bool down =
                track::foot_at(*track, state, 0, t).planted || track::foot_at(*track, state, 1, t).planted;
            in_the_air += !down;
        }
        EXPECT_LE(in_the_air, count / 20) << way.name;
    }
}

TEST(WalkingPeople, TurnByAtMostHalfATurnASecond)
{
    for (const test::Way &way : test::ways()) {
        const auto track = test::track_of(way.points);
        for (double t = 0.01; t < track->length_s; t += 0.01) {
            const double turn =
                between(track::state_at(*track, t - 0.01).heading_rad, track::state_at(*track, t).heading_rad);
            ASSERT_LE(turn, math::pi * 0.01 * 1.0001) << way.name << " at " << t;
        }
    }
}

TEST(WalkingPeople, FaceTheirWay)
{
    for (const test::Way &way : test::ways()) {
        if (std::string(way.name).rfind("ahead", 0) != 0) continue;
        const auto track = test::track_of(way.points);
        for (double t = 0.5; t < track->length_s; t += 0.1)
            ASSERT_LT(between(track::state_at(*track, t).heading_rad, 0), 0.01) << way.name << " at " << t;
    }
}

TEST(WalkingPeople, FaceWhereTheFileSaysThatTheyLook)
{
    std::vector<track::Point> points = test::points_of(10, 10, [](double t) { return glm::dvec2(0, t); });
    for (track::Point &point : points) point.heading_rad = 1.5;
    const auto track = test::track_of(points);
    for (double t = 0; t < 10; t += 0.1) ASSERT_LT(between(track::state_at(*track, t).heading_rad, 1.5), 0.001);
}

TEST(WalkingPeople, StandStillWhileTheFileTrembles)
{
    std::vector<track::Point> points = test::points_of(25, 20, [](double) { return glm::dvec2(0, 0); });
    for (track::Point &point : points) point.heading_rad = 0.3 * std::sin(8 * point.time_s);
    for (const size_t wrong : {100u, 200u, 201u, 202u, 300u}) points[wrong].heading_rad += 3;
    const auto track = test::track_of(points);
    for (double t = 0.3; t < 19.7; t += 0.1) {
        const track::State state = track::state_at(*track, t);
        ASSERT_TRUE(state.stands) << t;
        ASSERT_LT(between(state.heading_rad, 0), 0.35) << t;
    }
}

TEST(WalkingPeople, GoOnWithoutASwayThatTheirHeadsHad)
{
    const auto track = test::track_of(
        test::points_of(25, 20, [](double t) { return glm::dvec2(0.04 * std::sin(2 * math::pi * 0.9 * t), 1.3 * t); }));
    for (double t = 2; t < 18; t += 0.05) ASSERT_LT(std::fabs(track::position_at(*track, t).x), 0.008) << t;
}

TEST(WalkingPeople, TakeShorterStepsAtNearlyTheSamePaceWhenTheyAreSlow)
{
    const auto pace = [](double speed) {
        const auto track = test::track_of(test::points_of(10, 20, [=](double t) { return glm::dvec2(0, speed * t); }));
        double cycles = 0, before = track::state_at(*track, 5).phase;
        for (double t = 5.02; t <= 15; t += 0.02) {
            const double phase = track::state_at(*track, t).phase;
            cycles += phase - before - std::floor(phase - before + 0.5);
            before = phase;
        }
        return cycles / 10;
    };
    const double natural = pace(1.1);
    EXPECT_GT(natural, 0.7) << "a cycle has two steps, and people take 1.4 to 2.2 steps a second";
    EXPECT_LT(natural, 1.1);
    EXPECT_NEAR(pace(0.55), natural, 0.15 * natural);
    EXPECT_NEAR(pace(0.3), natural, 0.25 * natural);
    EXPECT_GT(pace(2.2), natural);
}

TEST(StandingPeople, AndTheirFeetRest)
{
    test::Soles soles(test::locomotion_of("citizen"));
    for (const test::Way &way : test::ways()) {
        if (std::string(way.name) != "stop and go") continue;
        const auto track = test::track_of(way.points);
        int stands = 0;
        for (double t = 0.02; t < track->length_s; t += 0.02) {
            const track::State a = track::state_at(*track, t - 0.02), b = track::state_at(*track, t);
            if (!a.stands || !b.stands) continue;
            ++stands;
            ASSERT_EQ(a.position, b.position) << t;
            ASSERT_EQ(a.heading_rad, b.heading_rad) << t;
            ASSERT_EQ(a.gait, 0) << t;
        }
        EXPECT_GT(stands, 300);
    }
}

TEST(WalkingPeople, HaveFeetThatNeverJump)
{
    test::Soles soles(test::locomotion_of("citizen"));
    for (const test::Way &way : test::ways()) {
        const auto track = test::track_of(way.points);
        glm::dvec3 before[2] = {glm::dvec3(0), glm::dvec3(0)};
        for (double t = 0; t < track->length_s; t += 0.01) {
            const track::State state = track::state_at(*track, t);
            const auto &posed = soles.at(*track, t);
            for (int f = 0; f < 2; ++f) {
                glm::dvec3 mean(0);
                for (const glm::dvec3 &p : posed.points[f]) mean += p / double(posed.points[f].size());
                const double c = std::cos(state.heading_rad), s = std::sin(state.heading_rad);
                const glm::dvec3 now =
                    state.position + glm::dvec3(mean.x * c + mean.z * s, mean.y, -mean.x * s + mean.z * c);
                const glm::dvec3 step = now - before[f];
                const double moved = std::sqrt(step.x * step.x + step.y * step.y + step.z * step.z);
                ASSERT_LT(t > 0 ? moved : 0, 0.075) << way.name << " at " << t;  // 7.5 m/s, a running foot's speed
                before[f] = now;
            }
        }
    }
}

TEST(WalkingPeople, KeepHeldFeetWithinTheSphereThatTheCrowdGivesThem)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    test::Soles soles(citizen);
    const model::Template &tmpl = *citizen.tmpl;
    const glm::dvec3 centre(tmpl.sklsroot.centre);
    const auto reach = [&](const glm::dvec3 &p) {
        const glm::dvec3 d = p - centre;
        return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    };
    const double allowed = double(tmpl.blend_radius.at(0)) + double(citizen.legs[0].max_shift);
    double farthest = 0;
    for (const test::Way &way : test::ways()) {
        const auto track = test::track_of(way.points);
        for (double t = 0; t < track->length_s; t += 0.05)
            for (const std::vector<glm::dvec3> &foot : soles.at(*track, t).points)
                for (const glm::dvec3 &p : foot) farthest = std::max(farthest, reach(p));
    }
    EXPECT_LT(farthest, allowed);
    EXPECT_GT(farthest, 0.9 * double(tmpl.sklsroot.radius));
}

// Tracks ask for less; whatever is asked for stays within the room.
TEST(HeldFeet, AreMovedNoFartherThanTheRoomThatTheCrowdGivesThem)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    pose::Workspace work(citizen.tmpl->rig, &citizen.tmpl->motion);
    const uint32_t ankle = citizen.legs[0].foot;
    double most = 0;
    for (int k = 0; k < 12; ++k)
        for (int way = 0; way < 8; ++way) {
            pose::PoseJob job = work.job();
            job.clip = citizen.clips.run, job.time_s = 0.06 * k;
            job.run();
            const glm::dvec3 before(work.global(ankle).column(3));
            pose::FootTarget target;
            target.leg = &citizen.legs[0], target.planted = true;
            target.x = static_cast<float>(3 * std::sin(0.785 * way)),
            target.z = static_cast<float>(3 * std::cos(0.785 * way));
            job.feet = {&target, 1};
            job.run();
            const glm::dvec3 moved = glm::dvec3(work.global(ankle).column(3)) - before;
            most = std::max(most, std::sqrt(moved.x * moved.x + moved.y * moved.y + moved.z * moved.z));
        }
    EXPECT_LE(most, double(citizen.legs[0].max_shift) * 1.0001);
    EXPECT_GT(most, 0.9 * double(citizen.legs[0].max_shift));
}
