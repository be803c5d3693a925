// The gait and pace of people who go at one speed and turn at one rate, and what a track tells of itself.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

constexpr double hz = 50;
constexpr uint32_t count = 200, middle = 100;

// The gait and phase of a path at a speed and a rate of turns.
track::FinePath gone(const track::Locomotion &people, double speed, double turn, double scale)
{
    track::FinePath path(std::pmr::get_default_resource());
    for (track::Array<double> *column : {&path.x, &path.y, &path.z, &path.heading}) column->assign(count, 0.0);
    for (uint32_t i = 0; i < count; ++i) path.z[i] = speed * i / hz, path.heading[i] = turn * i / hz;
    path.speed.assign(count, speed), path.turn.assign(count, turn), path.stands.assign(count, 0);
    path.last = count - 1;
    track::BuildSettings settings;
    settings.scale = scale / 0.5, settings.metres_per_unit = 0.5;
    EXPECT_EQ(track::make_gait(people, settings, path), 0u);
    return path;
}

// Cycles a second, and what they are by: the phase before the sample.
struct Pace {
    double cycles_s, phase;
};
Pace pace_of(const track::FinePath &path)
{
    return {(path.phase[middle] - path.phase[middle - 1]) * hz, path.phase[middle - 1]};
}

track::Locomotion without(bool slow, bool run, bool turn)
{
    const track::Locomotion &citizen = test::locomotion_of("citizen");
    track::LocomotionClips clips = citizen.clips;
    if (slow) clips.slow = model::none;
    if (run) clips.run = model::none;
    if (turn) clips.turn = model::none;
    track::Locomotion out(std::pmr::get_default_resource());
    track::measure(*citizen.tmpl, clips, out);
    return out;
}

// 0.5 at the slow walk's own speed and 1 at the walk's, on a straight line; up to 1.35 of it people walk faster, then
// they run more and more, up to the run's own speed and no sooner than 1.2 times as fast as they began to.
double gait_at(const track::Locomotion &people, double speed)
{
    const double walk = people.walking_speed();
    const bool slows = people.clips.slow != model::none;
    if (slows && speed < people.slow_speed()) return std::max(0.08, 0.5 * speed / people.slow_speed());
    if (slows && speed < walk) return 0.5 + 0.5 * (speed - people.slow_speed()) / (walk - people.slow_speed());
    if (speed < walk) return std::max(0.08, speed / walk);
    if (people.clips.run == model::none) return 1;
    const double begins = 1.35 * walk, runs = std::max(people.running_speed(), 1.2 * begins);
    return std::clamp(1 + (speed - begins) / (runs - begins), 1.0, 2.0);
}

}  // namespace

TEST(GaitOfAPath, IsByTheSpeedsOfItsClipsAndFeetKeepUpWithTheBody)
{
    for (const bool slow : {false, true})
        for (const bool run : {false, true}) {
            const track::Locomotion people = without(slow, run, true);
            for (const double scale : {1.0, 1.3})
                for (double speed = 0.02; speed < 4; speed += 0.09) {
                    const track::FinePath path = gone(people, speed * scale, 0, scale);
                    ASSERT_NEAR(path.gait[middle], gait_at(people, speed), 1e-6) << speed << ", " << scale;
                    const Pace pace = pace_of(path);
                    const double gait = path.gait[middle];
                    const double advance = double(track::cell_at(people, gait, 0, pace.phase).advance);
                    // No faster than 1.6 of the clips' own pace.
                    const double most = 1.6 / track::cycle_s_at(people, gait);
                    ASSERT_NEAR(pace.cycles_s, std::min(most, speed / advance), 1e-6) << speed << ", " << scale;
                }
        }
}

// Feet travel 8 cm for each radian that the body turns, and steps are as quick as if it were 25 cm.
TEST(GaitOfAPath, StepsWhileTheBodyTurns)
{
    const track::Locomotion people = without(false, false, true);
    for (const double speed : {0.0, 0.4, 1.5})
        for (const double turn : {0.3, 1.0, 3.0}) {
            const track::FinePath path = gone(people, speed, turn, 1);
            const double gait = gait_at(people, speed + 0.08 * turn);
            ASSERT_NEAR(path.gait[middle], gait, 1e-6) << speed << ", " << turn;
            EXPECT_EQ(path.turning[middle], 0);
            const Pace pace = pace_of(path);
            const double advance = double(track::cell_at(people, gait, 0, pace.phase).advance);
            ASSERT_NEAR(pace.cycles_s, std::min(1.6 / track::cycle_s_at(people, gait), (speed + 0.25 * turn) / advance),
                        1e-6)
                << speed << ", " << turn;
        }
}

// Below 0.12 m/s the clip that turns is shown from a tenth of a radian a second on: a cycle for 1.5 radians, at 0.7 to
// 1.6 of its own pace.
TEST(GaitOfAPath, TurnsOnTheSpotWithItsClipAtThePaceOfTheTurn)
{
    track::Locomotion people = without(false, false, false);
    for (const float cycle_s : {people.turn_cycle_s, 1.7f}) {
        people.turn_cycle_s = cycle_s;
        for (const double speed : {0.0, 0.11})
            for (double turn = 0.05; turn < 4; turn += 0.11) {
                const track::FinePath path = gone(people, speed, turn, 1);
                const bool turns = turn > 0.1;
                ASSERT_NEAR(path.turning[middle], turns, 1e-9) << turn;
                ASSERT_NEAR(path.gait[middle], gait_at(people, speed), 1e-6) << turn;
                if (!turns) continue;
                const double own = 1 / double(cycle_s), wanted = std::clamp(turn / 1.5, 0.7 * own, 1.6 * own);
                ASSERT_NEAR(pace_of(path).cycles_s, wanted, 1e-6) << speed << ", " << turn;
            }
        EXPECT_EQ(gone(people, 0.13, 2, 1).turning[middle], 0) << "it gets somewhere";
    }
}

TEST(Track, TellsHowFarItIsFromItsPointsAndHowItWent)
{
    for (const double unit : {1.0, 0.5})
        for (const test::Way &way : test::ways()) {
            std::vector<track::Point> points = way.points;
            for (track::Point &point : points) point.position /= unit;
            track::BuildSettings settings;
            settings.metres_per_unit = unit, settings.scale = 1 / unit;
            const auto track = test::track_of(points, "citizen", settings);
            double sum = 0, most = 0;
            for (const track::Point &point : points) {
                const glm::dvec3 d = (track::position_at(*track, point.time_s) - point.position) * unit;
                sum += std::hypot(d.x, d.z), most = std::max(most, std::hypot(d.x, d.z));
            }
            EXPECT_NEAR(track->mean_shift_m, sum / double(points.size()), 1e-9) << way.name;
            EXPECT_NEAR(track->max_shift_m, most, 1e-9) << way.name;
            double gone_m = 0, stood_s = 0;
            constexpr double step = 0.002;
            for (double t = step / 2; t < track->length_s; t += step) {
                gone_m += track::motion_at(*track, t).speed * unit * step;
                stood_s += track::state_at(*track, t).stands ? step : 0;
            }
            EXPECT_NEAR(track->distance_m, gone_m, 0.01 * gone_m + 0.01) << way.name;
            EXPECT_NEAR(track->standing_s, stood_s, 0.02 * track->length_s) << way.name;
        }
}
