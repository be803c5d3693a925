// Gaze: spine, neck and eyes share the turn towards a point (S0 5.3).
#include <cmath>

#include <gtest/gtest.h>

#include "lib/behave/command.h"
#include "lib/crowd/edits.h"
#include "test_actors.h"

namespace claque::behave
{

using namespace testing_support;

namespace
{

constexpr double eyes_height = 1.6, eyes_ahead = 0.1;

// A point seen from between the eyes at `yaw` to the left and `pitch` upwards.
glm::dvec3 towards(double yaw, double pitch, double distance = 5)
{
    return glm::dvec3(0, eyes_height, static_cast<double>(0.1f)) +
           distance * glm::dvec3(std::cos(pitch) * std::sin(yaw), std::sin(pitch), std::cos(pitch) * std::cos(yaw));
}

void look_at(TestActors &test_actors, uint32_t mechanism, const glm::dvec3 &point, double at_s, uint32_t actor = 0)
{
    command_gaze(test_actors.crowd, test_actors.ids[actor], mechanism, &point, at_s);
}

}  // namespace

TEST(Gaze, SharesTheTurnAsItsDescriptionSays)
{
    TestActors test_actors;
    const uint32_t g = test_actors.add(gaze());
    look_at(test_actors, g, towards(0.8, -0.4), 10);
    const std::vector<float> &dofs = test_actors.at(20);
    EXPECT_NEAR(dofs[spine_yaw], 0.2 * 0.8, 1e-4);
    EXPECT_NEAR(dofs[neck_yaw], 0.6 * 0.8 * 0.8, 1e-4);
    EXPECT_NEAR(dofs[left_yaw], 0.4 * 0.8 * 0.8, 1e-4);
    EXPECT_EQ(dofs[left_yaw], dofs[right_yaw]);
    EXPECT_NEAR(dofs[spine_pitch] + dofs[neck_pitch] + dofs[left_pitch], -0.4, 1e-4) << "together they look at it";
}

TEST(Gaze, PassesOnTheExcessOfAPartAndNeverLeavesARange)
{
    TestActors test_actors;
    crowd::Gaze all = gaze();
    all.spine_share = 0.9f;
    const uint32_t g = test_actors.add(all);
    look_at(test_actors, g, towards(1.4, 0), 0);
    const std::vector<float> &dofs = test_actors.at(5);
    EXPECT_EQ(dofs[spine_yaw], 0.5f) << "its range ends there";
    EXPECT_NEAR(dofs[neck_yaw], 0.6 * 0.9, 1e-4) << "its share of the rest";
    EXPECT_NEAR(dofs[left_yaw], 0.4 * 0.9, 1e-4);
}

TEST(Gaze, LooksOverTheLeftShoulderAtWhatIsExactlyBehindAndOverTheSameOneWhenItMoves)
{
    TestActors test_actors(2);
    const uint32_t g = test_actors.add(gaze());
    const glm::dvec3 behind(0, 1.6, -4);
    look_at(test_actors, g, behind, 0);
    EXPECT_EQ(test_actors.at(1)[spine_yaw], 0.5f);
    EXPECT_EQ(test_actors.at(1)[neck_yaw], 1.2f);
    EXPECT_EQ(test_actors.at(1)[left_yaw], 0.7f);
    look_at(test_actors, g, towards(-3.0, 0), 2);  // behind, a little to the right
    for (double t = 2; t < 4; t += 0.01) ASSERT_GT(test_actors.at(t, neck_yaw), 1.0f) << "no flip at " << t;
    look_at(test_actors, g, towards(-0.7, 0), 4, 1);
    look_at(test_actors, g, towards(3.0, 0), 6, 1);
    EXPECT_EQ(test_actors.at(9, 1)[neck_yaw], -1.2f) << "after looking right it looks over the right shoulder";
    command_gaze(test_actors.crowd, test_actors.ids[1], g, nullptr, 10);
    look_at(test_actors, g, towards(3.0, 0), 10.2, 1);
    EXPECT_EQ(test_actors.at(12, 1)[neck_yaw], -1.2f) << "also on its way back to the front";
}

TEST(Gaze, NeverGivesNaNNotAtItsOwnEyesNorStraightUp)
{
    TestActors test_actors;
    const uint32_t g = test_actors.add(gaze());
    double t = 0;
    for (const glm::dvec3 &point : {glm::dvec3(0, 1.6f, 0.1f), glm::dvec3(0, 50, 0.1f), glm::dvec3(0, -50, 0.1f),
                                    glm::dvec3(1e29, -1e29, 1e29), glm::dvec3(1e-30, 1.6f, 0.1f)}) {
        look_at(test_actors, g, point, t += 1);
        for (const float value : test_actors.at(t + 0.9)) EXPECT_TRUE(std::isfinite(value));
    }
}

TEST(Gaze, TurnsSmoothlyFromWhereItLookedAlsoInTheMiddleOfATurn)
{
    TestActors test_actors;
    crowd::Gaze wanders = gaze();
    wanders.wander_s = 1;
    const uint32_t g = test_actors.add(wanders);
    look_at(test_actors, g, towards(0.9, 0.2), 3);
    look_at(test_actors, g, towards(-0.9, -0.1), 3.2);
    // A turn of at most 2 radians in 0.4 s, with a peak speed of 1.5 times the average.
    EXPECT_LT(steepest(test_actors, 0, 5), 2 / 0.4 * 1.5);
    EXPECT_GT(steepest(test_actors, 3.1, 3.6), 1) << "it must turn";
    command_gaze(test_actors.crowd, test_actors.ids[0], g, nullptr, 5);
    EXPECT_LT(steepest(test_actors, 3.2, 8), 2 / 0.4 * 1.5);
}

TEST(Gaze, FollowsAPointThatIsGivenAnewInEveryFrame)
{
    TestActors test_actors;
    const uint32_t g = test_actors.add(gaze());
    const auto yaw_of = [](int frame) { return 0.3 + 0.01 * frame; };
    for (int frame = 0; frame < 60; ++frame) {
        look_at(test_actors, g, towards(yaw_of(frame), 0), frame / 60.0);
        const std::vector<float> &dofs = test_actors.at(frame / 60.0);
        const double turned = dofs[spine_yaw] + dofs[neck_yaw] + dofs[left_yaw];
        if (frame == 10) {
            EXPECT_GT(turned, 0.05) << "a new command does not stop the turn";
        }
        if (frame > 30) {
            EXPECT_NEAR(turned, yaw_of(frame), 1e-4) << "nor does it lag";
        }
    }
}

TEST(Gaze, FollowsAFixedPointWhileThePathCarriesTheEyesPastIt)
{
    TestActors test_actors;
    const uint32_t g = test_actors.add(gaze());
    crowd::RootPath ring(std::pmr::get_default_resource());
    ring.positions = {{10, 0, 0}, {0, 0, 10}, {-10, 0, 0}, {0, 0, -10}};
    ring.duration_s = 8;
    crowd::RootPathPlay motion;
    motion.path = test_actors.crowd.behaviours().add(std::move(ring));
    crowd::play_root_path(test_actors.crowd, test_actors.ids[0], motion);
    look_at(test_actors, g, glm::dvec3(9.5, 1.6, 0), 0);
    float least = 9, most = -9;
    for (int i = 0; i < 1600; ++i) {
        least = std::min(least, test_actors.at(i * 0.01, neck_yaw));
        most = std::max(most, test_actors.at(i * 0.01, neck_yaw));
    }
    EXPECT_GT(most - least, 1.0f) << "the neck follows";
    // It passes the point at 0.5 m with 8 m/s: 16 rad/s; a target behind is dropped at up to five times that.
    EXPECT_LT(steepest(test_actors, 1, 17), 80);
    // In the unclamped range spine, neck and eyes together point at the target.
    for (double t = 5.5; t < 6.5; t += 0.1) {
        const crowd::Transform root = root_transform_at(test_actors.crowd, 0, t);
        const std::vector<float> &dofs = test_actors.at(t);
        const double yaw = dofs[spine_yaw] + dofs[neck_yaw] + dofs[left_yaw];
        const glm::dquat q(root.orientation);
        const glm::dvec3 p = glm::conjugate(q) * (glm::dvec3(9.5, 1.6, 0) - root.position) - glm::dvec3(0, 1.6, 0.1);
        const double wanted = std::atan2(p.x, p.z);
        if (std::fabs(wanted) < 1.2) {
            EXPECT_NEAR(yaw, wanted, 1e-3) << t;
        }
    }
}

TEST(Gaze, DropsTargetsThatFallBehindAndThoseItPassesUnder)
{
    TestActors test_actors;
    const uint32_t g = test_actors.add(gaze());
    crowd::RootPath ring(std::pmr::get_default_resource());
    ring.positions = {{10, 0, 0}, {0, 0, 10}, {-10, 0, 0}, {0, 0, -10}};
    ring.duration_s = 8;
    crowd::RootPathPlay motion;
    motion.path = test_actors.crowd.behaviours().add(std::move(ring));
    crowd::play_root_path(test_actors.crowd, test_actors.ids[0], motion);
    look_at(test_actors, g, glm::dvec3(100, 1.6, 0), 0);
    // It turns with about 1 rad/s; a target that falls behind is dropped within half a radian of the turn.
    EXPECT_LT(steepest(test_actors, 1, 17), 8);
    // Right above the path, 4 m over the eyes, which pass under it with 8 m/s.
    const crowd::Transform under = root_transform_at(test_actors.crowd, 0, 1.2345);
    const glm::dvec3 eyes = under.position + glm::dquat(under.orientation) * glm::dvec3(0, 1.6f, 0.1f);
    for (const double aside : {0.0, 0.02, -0.05}) {
        look_at(test_actors, g, eyes + glm::dquat(under.orientation) * glm::dvec3(aside, 4, 0), 0);
        EXPECT_LT(steepest(test_actors, 0.5, 7.5), 25) << aside;
    }
}

TEST(Gaze, WandersWithinItsBoundsAboutAsOftenAsItSays)
{
    TestActors test_actors;
    crowd::Gaze wanders = gaze();
    wanders.wander_s = 2;
    wanders.wander_yaw = 0.5f, wanders.wander_pitch = 0.2f;
    test_actors.add(wanders);
    int rests = 0;
    bool moved = false;
    float last = 0;
    for (int i = 0; i < 100000; ++i) {
        const std::vector<float> &dofs = test_actors.at(i * 0.01);
        ASSERT_LE(std::fabs(dofs[spine_yaw] + dofs[neck_yaw] + dofs[left_yaw]), 0.5001f);
        ASSERT_LE(std::fabs(dofs[spine_pitch] + dofs[neck_pitch] + dofs[left_pitch]), 0.2001f);
        const bool moves = dofs[neck_yaw] != last;
        if (moved && !moves) ++rests;
        moved = moves, last = dofs[neck_yaw];
    }
    EXPECT_NEAR(rests, 500, 50) << "in 1000 s";
}

TEST(Gaze, WandersSmoothlyAlsoWhenItHasLessTimeThanItTurnsIn)
{
    TestActors test_actors;
    crowd::Gaze wanders = gaze();
    wanders.wander_s = 0.2f, wanders.turn_s = 5;
    test_actors.add(wanders);
    EXPECT_LT(steepest(test_actors, 0, 20), 1 / 0.1 * 1.5) << "a turn of 1 radian in half of the time";
}

TEST(Gaze, LevelsDropEyesThenNeckThenThePitchOfTheSpine)
{
    TestActors test_actors;
    crowd::Mechanism mechanism;
    mechanism.kind = gaze();
    mechanism.level_m[0] = 10, mechanism.level_m[1] = 20, mechanism.level_m[2] = 30;
    mechanism.off_m = 40;
    const uint32_t g = test_actors.add(std::move(mechanism));
    look_at(test_actors, g, towards(0.8, 0.4), 0);
    const std::vector<float> near = test_actors.at(5, 0, 9.9f), no_eyes = test_actors.at(5, 0, 10),
                             no_neck = test_actors.at(5, 0, 20), flat = test_actors.at(5, 0, 35),
                             gone = test_actors.at(5, 0, 40);
    EXPECT_NE(near[left_yaw], 0);
    EXPECT_EQ(no_eyes[left_yaw], 0);
    EXPECT_EQ(no_eyes[neck_yaw], near[neck_yaw]) << "the head stays where it was";
    EXPECT_EQ(no_neck[neck_yaw], 0);
    EXPECT_EQ(no_neck[spine_pitch], near[spine_pitch]);
    EXPECT_EQ(flat[spine_pitch], 0);
    EXPECT_EQ(flat[spine_yaw], near[spine_yaw]);
    EXPECT_EQ(gone[spine_yaw], 0);
}

TEST(Gaze, LevelsCountTheRemainingParts)
{
    TestActors test_actors;
    crowd::Mechanism mechanism;
    crowd::Gaze head = gaze();
    head.spine_yaw = head.spine_pitch = model::none;
    mechanism.kind = head;
    mechanism.level_m[0] = 10, mechanism.level_m[1] = 20;
    const uint32_t g = test_actors.add(std::move(mechanism));
    look_at(test_actors, g, towards(0.5, 0.4), 0);
    EXPECT_NEAR(test_actors.at(5)[neck_yaw], 0.6 * 0.5, 1e-4);
    EXPECT_NE(test_actors.at(5)[left_yaw], 0);
    EXPECT_EQ(test_actors.at(5, 0, 15)[left_yaw], 0);
    EXPECT_NE(test_actors.at(5, 0, 15)[neck_pitch], 0);
    EXPECT_EQ(test_actors.at(5, 0, 25)[neck_pitch], 0);
    EXPECT_NE(test_actors.at(5, 0, 25)[neck_yaw], 0);
}

}  // namespace claque::behave
