// Root paths: the Skeleton Root moves round the Reference Point (S0 3, 4.1).
#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/crowd/edits.h"
#include "test_actors.h"

namespace claque::behave
{

using namespace testing_support;

namespace
{

crowd::RootPath flight(std::initializer_list<glm::vec3> positions, float duration_s = 8)
{
    crowd::RootPath path(std::pmr::get_default_resource());
    path.positions = positions;
    path.duration_s = duration_s;
    path.bank = 0.5f, path.max_bank = 0.9f;
    return path;
}

crowd::RootPath any_flight(uint32_t seed, uint32_t count)
{
    crowd::RootPath path = flight({}, 10);
    for (uint32_t i = 0; i < count; ++i) {
        const auto draw = [&](uint32_t k) {
            return base::unit(base::hash(seed, i, base::Purpose::position, k)) - 0.5f;
        };
        path.positions.push_back(glm::vec3(40 * draw(0), 10 * draw(1), 40 * draw(2)));
    }
    return path;
}

crowd::RootPath table()
{
    crowd::RootPath path(std::pmr::get_default_resource());
    path.flight = false;
    path.times_s = {0, 1, 3, 4};
    path.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 0, 0}};
    const float h = std::sqrt(0.5f);
    path.rotations = {{1, 0, 0, 0}, {h, 0, h, 0}, {-h, 0, -h, 0}, {1, 0, 0, 0}};
    path.duration_s = 4;
    return path;
}

glm::dvec3 ahead(const crowd::Transform &place) { return glm::dquat(place.orientation) * glm::dvec3(0, 0, 1); }
glm::dvec3 above(const crowd::Transform &place) { return glm::dquat(place.orientation) * glm::dvec3(0, 1, 0); }

bool is_a_place(const crowd::Transform &place)
{
    bool all = true;
    for (int k = 0; k < 3; ++k) all = all && std::isfinite(place.position[k]);
    return all && std::fabs(glm::length(place.orientation) - 1) < 1e-5f;
}

double radians_between(const glm::quat &a, const glm::quat &b)
{
    const double cosine = std::fabs(glm::dot(glm::dquat(a), glm::dquat(b)));
    return 2 * std::acos(std::min(1.0, cosine));
}

}  // namespace

TEST(Flight, MeetsItsPositionsAtEqualTimes)
{
    const crowd::RootPath path = any_flight(3, 6);
    for (uint32_t i = 0; i < 6; ++i)
        EXPECT_NEAR(glm::length(transform_on(path, i * 10.0 / 6).position - glm::dvec3(path.positions[i])), 0, 1e-9)
            << i;
}

TEST(Flight, LooksWhereItGoesWithItsHeadUp)
{
    for (uint32_t seed = 0; seed < 20; ++seed) {
        crowd::RootPath path = any_flight(seed, 5);
        path.bank = 0;
        for (double t = 0; t < 9.99; t += 0.0137) {
            const crowd::Transform here = transform_on(path, t);
            const glm::dvec3 step = transform_on(path, t + 1e-5).position - here.position;
            if (glm::length(step) < 1e-6) continue;
            const glm::dvec3 forward = ahead(here), up = above(here);
            EXPECT_NEAR(glm::length(forward - glm::normalize(step)), 0, 1e-3) << seed << " at " << t;
            EXPECT_GE(up.y, -1e-6);
            EXPECT_NEAR(glm::dot(up, glm::cross(forward, glm::dvec3(0, 1, 0))), 0, 1e-5) << "wings level";
        }
    }
}

TEST(Flight, LooksWhereItGoesOnWhereItTurnsRound)
{
    const crowd::RootPath path = flight({{0, 0, 0}, {3, 0, 4}});
    EXPECT_NEAR(glm::length(ahead(transform_on(path, 0)) - glm::dvec3(0.6, 0, 0.8)), 0, 1e-6);
    EXPECT_NEAR(glm::length(ahead(transform_on(path, 4)) + glm::dvec3(0.6, 0, 0.8)), 0, 1e-6);
    for (double t = 0; t < 8; t += 0.01)
        EXPECT_GT(above(transform_on(path, t)).y, 0.9999) << "a turn by 180 degrees has no side";
}

TEST(Flight, BanksToTheInsideOfItsTurnAndNotFurtherThanItMay)
{
    // Round the origin, to the left: from +x over -z.
    crowd::RootPath path = flight({{10, 0, 0},
                                   {7.07f, 0, -7.07f},
                                   {0, 0, -10},
                                   {-7.07f, 0, -7.07f},
                                   {-10, 0, 0},
                                   {-7.07f, 0, 7.07f},
                                   {0, 0, 10},
                                   {7.07f, 0, 7.07f}});
    const auto lean = [&](double t) {
        const crowd::Transform here = transform_on(path, t);
        return std::asin(glm::dot(above(here), glm::normalize(-here.position)));
    };
    for (double t = 0; t < 8; t += 0.1) EXPECT_NEAR(lean(t), 0.5 * 2 * 3.14159 / 8, 0.02) << t;
    path.max_bank = 0.1f;
    for (double t = 0; t < 8; t += 0.1) EXPECT_NEAR(lean(t), 0.1, 1e-3) << t;
    std::reverse(path.positions.begin(), path.positions.end());
    for (double t = 0; t < 8; t += 0.1) EXPECT_NEAR(lean(t), 0.1, 1e-3) << "in the other direction too " << t;
}

TEST(Flight, TurnsSmoothlyAlsoWhereSegmentsMeet)
{
    for (uint32_t seed = 0; seed < 20; ++seed) {
        crowd::RootPath path = flight({}, 10);
        for (uint32_t i = 0; i < 8; ++i) {
            const auto draw = [&](uint32_t k) { return base::unit(base::hash(seed, i, base::Purpose::position, k)); };
            const float a = 0.7854f * (static_cast<float>(i) + 0.4f * draw(0)), r = 15 + 10 * draw(1);
            path.positions.push_back(glm::vec3(r * std::sin(a), 5 * draw(2), r * std::cos(a)));
        }
        double worst = 0;
        glm::quat before = transform_on(path, 9.999).orientation;
        for (int i = 0; i < 10000; ++i) {
            const glm::quat now = transform_on(path, i * 0.001).orientation;
            worst = std::max(worst, radians_between(before, now));
            before = now;
        }
        EXPECT_LT(worst, 0.006) << seed << ": 6 rad/s, where a round turn of 10 s has 0.6";
    }
}

TEST(Flight, IsExactlyPeriodicAndRunsBothWays)
{
    TestActors test_actors;
    crowd::RootPathPlay motion;
    motion.path = test_actors.crowd.behaviours().add(any_flight(5, 7));
    const crowd::Id id = test_actors.ids[0];
    crowd::play_root_path(test_actors.crowd, id, motion);
    const auto same = [](const crowd::Transform &a, const crowd::Transform &b) {
        return a.position == b.position && a.orientation == b.orientation;
    };
    for (double t = 0; t < 10; t += 0.25)
        for (const int rounds : {1, 7, -3, 1000})
            EXPECT_TRUE(same(root_transform_at(test_actors.crowd, 0, t),
                             root_transform_at(test_actors.crowd, 0, t + rounds * 10.0)))
                << t;
    const crowd::Transform at_three = root_transform_at(test_actors.crowd, 0, 3);
    motion.speed = -1, motion.phase_s = 4, motion.start_s = 100;
    crowd::play_root_path(test_actors.crowd, id, motion);
    EXPECT_TRUE(same(root_transform_at(test_actors.crowd, 0, 101), at_three));
    EXPECT_TRUE(same(root_transform_at(test_actors.crowd, 0, 111), at_three));
    motion.path = model::none;
    crowd::play_root_path(test_actors.crowd, id, motion);
    EXPECT_TRUE(same(root_transform_at(test_actors.crowd, 0, 107), crowd::Transform()));
}

TEST(Flight, ReachIsAnUpperBoundWithinFivePerCent)
{
    for (uint32_t seed = 0; seed < 40; ++seed) {
        const crowd::RootPath path = any_flight(seed, 2 + seed % 9);
        const double reach = double(reach_of(path));
        double farthest = 0;
        for (int i = 0; i < 100000; ++i)
            farthest = std::max(farthest, glm::length(transform_on(path, i * 1e-4).position));
        EXPECT_GE(reach, farthest) << seed;
        EXPECT_LE(reach, 1.05 * farthest) << seed;
    }
}

TEST(Flight, IsNeverNotANumber)
{
    const std::initializer_list<glm::vec3> hard[] = {
        {{0, 0, 0}, {0, 0, 0}},                                   // stands still
        {{0, 0, 0}, {0, 5, 0}},                                   // up and down
        {{0, 0, 0}, {3, 0, 4}},                                   // back and forth
        {{0, 0, 0}, {0, 5, 0}, {0, 9, 0}, {0, 5, 0}},             // up and down a pole
        {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {5, 1, 1}, {1, 1, 1}},  // waits for a while
        {{0, 0, 5}, {0, 5, 0}, {0, 0, -5}, {0, -5, 0}},           // a loop
        {{1e9f, 1e9f, 1e9f}, {-1e9f, -1e9f, -1e9f}, {0, 0, 1e-9f}},
    };
    for (const auto &positions : hard) {
        const crowd::RootPath path = flight(positions);
        EXPECT_TRUE(std::isfinite(reach_of(path)));
        for (int i = 0; i < 8000; ++i) ASSERT_TRUE(is_a_place(transform_on(path, i * 0.001))) << i;
    }
}

TEST(Table, GoesStraightFromKeyToKeyAndTurnsByTheShorterArc)
{
    const crowd::RootPath path = table();
    EXPECT_EQ(transform_on(path, 0).position, glm::dvec3(0));
    EXPECT_EQ(transform_on(path, 0.5).position, glm::dvec3(1, 0, 0));
    EXPECT_EQ(transform_on(path, 2).position, glm::dvec3(2, 0.5, 0));
    EXPECT_EQ(transform_on(path, 3.5).position, glm::dvec3(1, 0.5, 0));
    EXPECT_NEAR(radians_between(transform_on(path, 0.5).orientation, glm::quat(1, 0, 0, 0)), 3.14159265 / 4, 1e-5);
    EXPECT_NEAR(radians_between(transform_on(path, 2).orientation, path.rotations[1]), 0, 1e-3) << "q and -q are one";
    EXPECT_NEAR(reach_of(path), std::sqrt(5.0), 1e-5);
}

TEST(Table, IsContinuousAllRound)
{
    const crowd::RootPath path = table();
    crowd::Transform before = transform_on(path, 3.999);
    for (int i = 0; i < 4000; ++i) {
        const crowd::Transform now = transform_on(path, i * 0.001);
        EXPECT_LT(glm::length(now.position - before.position), 0.0025) << i;
        EXPECT_LT(radians_between(now.orientation, before.orientation), 0.003) << i;
        before = now;
    }
}

// By differences over a tenth of a millisecond; rotations have the precision of float, so theirs take longer.
TEST(RootSpeed, IsThatOfTheTransforms)
{
    const crowd::RootPath paths[] = {any_flight(3, 6), any_flight(8, 2), table()};
    for (const crowd::RootPath &path : paths)
        for (const float pace : {1.0f, -0.4f}) {
            TestActors test_actors;
            const uint32_t number = test_actors.crowd.behaviours().add(crowd::RootPath(path));
            crowd::RootPathPlay motion;
            motion.path = number, motion.speed = pace;
            crowd::play_root_path(test_actors.crowd, test_actors.ids[0], motion);
            const double duration = double(path.duration_s) / std::fabs(double(pace));
            for (double t = 0.0031; t < duration; t += duration / 97) {
                const crowd::Transform a = root_transform_at(test_actors.crowd, 0, t);
                const crowd::Transform b = root_transform_at(test_actors.crowd, 0, t + 1e-4);
                const RootSpeed speed = root_speed_at(test_actors.crowd, 0, t + 5e-5);
                EXPECT_NEAR(speed.speed, glm::length(b.position - a.position) / 1e-4, 1e-3 * (1 + speed.speed)) << t;
                const double round = t * std::fabs(double(pace));
                if (path.flight || std::fabs(round - std::round(round)) < 0.06) continue;  // near a key
                const crowd::Transform later = root_transform_at(test_actors.crowd, 0, t + 0.05);
                EXPECT_NEAR(speed.turn_rad_s, radians_between(a.orientation, later.orientation) / 0.05, 0.02) << t;
            }
        }
    const TestActors without;
    EXPECT_EQ(root_speed_at(without.crowd, 0, 3).speed, 0);
}

}  // namespace claque::behave
