// What is packed of a fine path is the nearest that its samples can hold, on a grid from which the path is found again;
// steps and stands are those of plants and samples, one by one.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "lib/math/trig.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

constexpr uint32_t packed_count = 241;

// A path of which all numbers go up and down `waves` times, or one of them alone.
track::FinePath waving(double waves, int which = -1)
{
    track::FinePath path(std::pmr::get_default_resource());
    for (track::Array<double> *column :
         {&path.x, &path.y, &path.z, &path.heading, &path.gait, &path.phase, &path.turning})
        column->resize(packed_count);
    path.stands.assign(packed_count, 0), path.idle.assign(packed_count, 0);
    path.last = packed_count - 1;
    for (uint32_t i = 0; i < packed_count; ++i) {
        const double wave = std::sin(2 * math::pi * waves * i / packed_count + 0.3);
        const auto own = [&](int column) { return which < 0 || which == column ? wave : 0; };
        path.x[i] = 100 + own(0), path.y[i] = 3 + 0.5 * own(1), path.z[i] = -7 + 2 * own(2);
        path.heading[i] = 2 * own(3), path.gait[i] = 1 + 0.9 * own(4), path.phase[i] = 5 + 2 * own(5);
        path.turning[i] = 0.5 + 0.5 * own(6), path.idle[i] = i / 80;
    }
    return path;
}

double off(double a, double b) { return std::fabs(std::remainder(a - b, 1.0)); }

}  // namespace

TEST(PackedPath, HasTheNearestNumbersOnTheCoarsestGridFromWhichItIsFound)
{
    std::map<int, std::vector<uint32_t>> steps;
    for (double waves = 0.1; waves < 100; waves *= 1.1)
        for (int which = -1; which < 7; ++which) {
            const track::FinePath path = waving(waves, which);
            track::Track track(std::pmr::get_default_resource());
            track.length_s = (packed_count - 1) / 50.0;
            track::pack(path, track);
            const auto every = static_cast<uint32_t>(50 / track.rate_hz + 0.5);
            steps[which].push_back(every);
            ASSERT_EQ(track.samples.size(), (packed_count - 1) / every + 1);
            EXPECT_DOUBLE_EQ(track.rate_hz, 50.0 / every);
            EXPECT_DOUBLE_EQ(track.min_height_m, *std::min_element(path.y.begin(), path.y.end()));
            for (uint32_t k = 0; k < track.samples.size(); ++k) {
                const track::Sample &sample = track.samples[k];
                const uint32_t i = k * every;
                ASSERT_LE(std::fabs(sample.x / 8192.0 - path.x[i]), 0.5001 / 8192) << waves;
                ASSERT_LE(std::fabs(sample.z / 8192.0 - path.z[i]), 0.5001 / 8192) << waves;
                ASSERT_LE(std::fabs(track.min_height_m + sample.height * track.height_step_m - path.y[i]),
                          0.5001 * track.height_step_m);
                ASSERT_LE(off(sample.heading / 65536.0, path.heading[i] / (2 * math::pi)), 0.5001 / 65536) << waves;
                ASSERT_LE(off(sample.phase / 65536.0, path.phase[i]), 0.5001 / 65536) << waves;
                ASSERT_LE(std::fabs(sample.gait / 127.0 - path.gait[i]), 0.5001 / 127) << waves;
                ASSERT_LE(std::fabs(track::turn_of(sample.flags) / 31.0 - path.turning[i]), 0.5001 / 31) << waves;
                ASSERT_EQ(track::idle_of(sample.flags), path.idle[i]);
            }
            // Half a millimetre, and the rounding of heights; a hundredth of a radian, a fiftieth of a cycle.
            for (uint32_t i = 0; every > 1 && i < packed_count; ++i) {
                const track::State state = track::state_at(track, i / 50.0);
                ASSERT_NEAR(state.position.x, path.x[i], 0.0005 + 1e-9);
                ASSERT_NEAR(state.position.y, path.y[i], 0.0005 + track.height_step_m + 1e-9);
                ASSERT_NEAR(state.position.z, path.z[i], 0.0005 + 1e-9);
                ASSERT_LE(2 * math::pi * off(state.heading_rad / (2 * math::pi), path.heading[i] / (2 * math::pi)),
                          0.01);
                ASSERT_LE(off(state.phase, path.phase[i]), 0.02);
                ASSERT_NEAR(double(state.gait), path.gait[i], 0.05);
                ASSERT_NEAR(double(state.turn), path.turning[i], 0.05);
            }
        }
    for (const auto &[which, own] : steps) {
        EXPECT_EQ(own.front(), 5u) << which;
        EXPECT_EQ(own.back(), 1u) << which;
        const std::set<uint32_t> all(own.begin(), own.end());
        EXPECT_TRUE(all.count(4) && all.count(2)) << which;
    }
}

TEST(PackedPath, OfALevelWayHasNoHeights)
{
    track::FinePath path = waving(0.2);
    path.y.assign(packed_count, 4.5);
    track::Track track(std::pmr::get_default_resource());
    track.length_s = (packed_count - 1) / 50.0;
    track::pack(path, track);
    EXPECT_EQ(track.height_step_m, 0);
    for (double t = 0; t < 4; t += 0.1) EXPECT_DOUBLE_EQ(track::position_at(track, t).y, 4.5);
}

TEST(StepsAndStands, AreThosePlantsAndSamplesThatBeginInARange)
{
    const auto made = test::track_of(test::ways()[8].points);  // stop and go
    const std::vector<double> ends = {-3, 0, 0.3, 0.99, 1, 1.4, 5.02, 7.7, 11, 12.34, 23.9, 24, 30};
    size_t all_steps = 0, all_stands = 0;
    for (const double from : ends)
        for (const double to : ends) {
            std::vector<std::pair<double, int>> wanted, found;
            for (int foot = 0; foot < 2; ++foot)
                for (const track::Plant &plant : made->plants[foot]) {
                    const double s = double(plant.begin_s);
                    if (s > 0 && s >= from && s <= to && s <= made->length_s) wanted.emplace_back(s, foot);
                }
            track::for_steps(*made, from, to, [&](double s, int foot) { found.emplace_back(s, foot); });
            EXPECT_EQ(found, wanted) << from << " to " << to;
            all_steps = std::max(all_steps, found.size());
            std::vector<std::pair<double, uint32_t>> stands, stood;
            for (size_t i = 1; i < made->samples.size(); ++i) {
                const double s = double(i) / made->rate_hz;
                const bool begins =
                    made->samples[i].flags & track::stands_flag && !(made->samples[i - 1].flags & track::stands_flag);
                // Give or take a sample.
                if (begins && s > from - 1 / made->rate_hz && s <= to)
                    stands.emplace_back(s, track::idle_of(made->samples[i].flags));
            }
            track::for_stands(*made, from, to, [&](double s, uint32_t idle) { stood.emplace_back(s, idle); });
            EXPECT_EQ(stood, stands) << from << " to " << to;
            all_stands = std::max(all_stands, stood.size());
        }
    EXPECT_GT(all_steps, 20u);
    EXPECT_EQ(all_stands, 4u);
}

// Before its first plant a foot is as far off as when it comes down, behind its last as when it was lifted; what it is
// off in height fades within 0.3 s.
TEST(StepsAndStands, LeaveFeetBeforeTheFirstAndBehindTheLastAsTheseHaveThem)
{
    track::Track track(std::pmr::get_default_resource());
    track.locomotion = &test::locomotion_of("citizen");
    track.rate_hz = 8, track.length_s = 5, track.samples.resize(41);
    track::Plant plant;
    plant.begin_s = 2, plant.end_s = 3, plant.heading_rad = 0.25f, plant.y = 0.5f;
    plant.begin_x = 0.1f, plant.begin_z = -0.2f, plant.end_x = 0.3f, plant.end_z = 0.4f;
    track.plants[0] = track.plants[1] = {plant};
    track::index_plants(track);
    for (int foot = 0; foot < 2; ++foot)
        for (double t = -1; t < 6; t += 0.0625) {
            if (t >= 2 && t <= 3) continue;
            const track::Correction found = track::correction_at(track, track::state_at(track, t), foot, t);
            const bool before = t < 2;
            EXPECT_NEAR(found.x, before ? 0.1 : 0.3, 1e-6) << t;
            EXPECT_NEAR(found.z, before ? -0.2 : 0.4, 1e-6) << t;
            EXPECT_NEAR(found.turn_rad, 0.25, 1e-6) << t;
            const double gone = std::min(1.0, (before ? 2 - t : t - 3) / 0.3);
            EXPECT_NEAR(found.y, 0.5 * (1 - gone * gone * (3 - 2 * gone)), 1e-6) << t;
        }
    // A swing that a piece before has begun fades until it lands.
    track.swings[1] = {0.5f, -0.25f, 0.125f, 1.5f, 0.75f};
    for (double t = 0; t < 2; t += 0.0625) {
        const track::Correction found = track::correction_at(track, track::state_at(track, t), 1, t);
        const double part = std::min(1.0, t / 1.5), left = 1 - part * part * (3 - 2 * part);
        EXPECT_NEAR(found.x, 0.1 + 0.5 * left, 1e-6) << t;
        EXPECT_NEAR(found.z, -0.2 - 0.25 * left, 1e-6) << t;
        EXPECT_NEAR(found.turn_rad, 0.25 + 0.125 * left, 1e-6) << t;
        const double gone = std::min(1.0, (2 - t) / 0.3);
        EXPECT_NEAR(found.y, 0.5 * (1 - gone * gone * (3 - 2 * gone)) + 0.75 * left, 1e-6) << t;
    }
}
