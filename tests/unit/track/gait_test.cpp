// Slow people, people that turn on the spot and people that stand show clips of their own.
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/math/trig.h"
#include "tests/unit/track/feet.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

std::vector<pose::Layer> layers_at(const track::Track &track, double time_s)
{
    const track::State state = track::state_at(track, time_s);
    pose::Layer layers[3];
    const uint32_t count =
        track::layers_of(*track.locomotion, state.gait, state.turn, state.phase, state.idle, time_s, layers);
    return {layers, layers + count};
}

// How much of the pose a clip has: what the layers above it leave.
double share_of(const std::vector<pose::Layer> &layers, uint32_t clip)
{
    double share = 0;
    for (const pose::Layer &layer : layers)
        share = share * (1 - double(layer.weight)) + (layer.clip == clip ? double(layer.weight) : 0);
    return share;
}

// Stands from the fourth to the eighth second, then leaves in a direction from its old one.
std::unique_ptr<track::Track> turning(double angle_rad)
{
    return test::track_of(test::points_of(10, 14, [=](double t) {
        const double gone = t < 4 ? 0 : std::max(0.0, t - 8.0);
        return glm::dvec2(gone * std::sin(angle_rad), 1.2 * std::min(t, 4.0) + gone * std::cos(angle_rad));
    }));
}

std::vector<track::Plant> between(const track::Track &track, int foot, double from_s, double to_s)
{
    std::vector<track::Plant> out;
    for (const track::Plant &plant : track.plants[foot])
        if (double(plant.begin_s) > from_s && double(plant.begin_s) < to_s) out.push_back(plant);
    return out;
}

}  // namespace

TEST(SlowWalk, IsMeasuredSlowerThanTheWalkAndInStepWithIt)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    // lib/figures/clips/walk_slow.cpp: 0.68 m a cycle of 1.2 s while a foot carries weight.
    EXPECT_NEAR(citizen.stride[track::slow_step], 0.68, 0.04);
    EXPECT_NEAR(citizen.slow_speed(), 0.57, 0.04);
    for (const float phase : {citizen.slow_phase, citizen.turn_phase})
        EXPECT_LT(std::fabs(phase - std::floor(phase + 0.5f)), 0.06f);
}

TEST(SlowWalk, IsWhatSlowPeopleShow)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    const auto share = [&](double speed, uint32_t clip) {
        const auto track = test::track_of(test::points_of(10, 10, [=](double t) { return glm::dvec2(0, speed * t); }));
        return share_of(layers_at(*track, 5), clip);
    };
    const double slow = citizen.slow_speed();
    EXPECT_GT(share(slow, citizen.clips.slow), 0.97);
    EXPECT_NEAR(share(0.5 * slow, citizen.clips.slow), 0.5, 0.03);
    EXPECT_NEAR(share(0.5 * slow, citizen.clips.idles[0]) + share(0.5 * slow, citizen.clips.idles[1]) +
                    share(0.5 * slow, citizen.clips.idles[2]),
                0.5, 0.03);
    EXPECT_EQ(share(0.5 * slow, citizen.clips.walk), 0);
    EXPECT_GT(share(0.5 * (slow + citizen.walking_speed()), citizen.clips.walk), 0.4);
    EXPECT_EQ(share(1.3, citizen.clips.slow), 0);
}

TEST(SlowWalk, OfAClipThatIsNoSlowerIsRefused)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    track::LocomotionClips clips = citizen.clips;
    clips.slow = citizen.clips.run;
    track::Locomotion out(std::pmr::get_default_resource());
    EXPECT_THROW(track::measure(*citizen.tmpl, clips, out), base::Error);
    clips = citizen.clips, clips.turn = 1000;
    EXPECT_THROW(track::measure(*citizen.tmpl, clips, out), base::Error);
}

TEST(TurnOnTheSpot, ShowsTheTurnAndStepsWithTheFootOfItsSide)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    for (const double angle : {0.5 * math::pi, -0.5 * math::pi, 0.95 * math::pi}) {
        const auto track = turning(angle);
        double most = 0, first_s = 0, last_s = 0;
        for (double t = 4; t < 10; t += 0.02) {
            const track::State state = track::state_at(*track, t);
            most = std::max(most, share_of(layers_at(*track, t), citizen.clips.turn));
            if (state.turn > 0.5f) first_s = first_s > 0 ? first_s : t, last_s = t;
            if (track::motion_at(*track, t).speed > 0.5) {
                EXPECT_LT(state.turn, 0.2f) << t;
            }
        }
        EXPECT_GT(most, 0.9) << angle;
        EXPECT_GT(last_s, first_s + 0.3);
        // Both feet step; the one on the side of the turn is lifted first.
        const int side = angle > 0 ? 0 : 1;
        std::vector<track::Plant> own = between(*track, side, 5, 10), other = between(*track, 1 - side, 5, 10);
        ASSERT_FALSE(own.empty());
        ASSERT_FALSE(other.empty());
        EXPECT_LT(own[0].begin_s, other[0].begin_s) << angle;
        EXPECT_LT(double(own[0].begin_s), last_s + 0.4);
    }
}

TEST(TurnOnTheSpot, LiftsTheFeet)
{
    const auto track = turning(0.5 * math::pi);
    test::Soles soles(*track->locomotion);
    double highest[2] = {0, 0};
    for (double t = 5; t < 8; t += 0.02) {
        if (track::motion_at(*track, t).speed > 0.05) continue;
        const auto &posed = soles.at(*track, t);
        for (int f = 0; f < 2; ++f) {
            double low = 1e9;
            for (const glm::dvec3 &p : posed.points[f]) low = std::min(low, p.y);
            highest[f] = std::max(highest[f], low);
        }
    }
    EXPECT_GT(highest[0], 0.02);
    EXPECT_GT(highest[1], 0.02);
}

TEST(StandingPeople, ShowDifferentClipsBySeed)
{
    std::set<uint32_t> idles;
    for (uint64_t seed = 0; seed < 20; ++seed) {
        track::BuildSettings settings;
        settings.seed = seed;
        const auto track =
            test::track_of(test::points_of(10, 5, [](double) { return glm::dvec2(1, 2); }), "citizen", settings);
        idles.insert(track::state_at(*track, 2).idle);
    }
    EXPECT_EQ(idles.size(), 3u);
}

TEST(TurnOnTheSpot, GoesOneWay)
{
    const auto track = turning(0.5 * math::pi);
    double before = 0;
    for (double t = 4; t < 10; t += 0.02) {
        const double heading = track::state_at(*track, t).heading_rad;
        ASSERT_GE(heading, before - 0.01) << t;
        // The person looks along its way before it is fast.
        if (track::motion_at(*track, t).speed > 0.3 && t > 8) {
            EXPECT_GT(heading, 1.4) << t;
        }
        before = heading;
    }
}
