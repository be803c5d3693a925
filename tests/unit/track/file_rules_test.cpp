// Each rule of a saved track, on both sides of its bound: what a track can hold is read, what none can is refused.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/track/build.h"
#include "lib/track/track_file.h"
#include "tests/unit/track/stairs.h"

using namespace claque;

namespace
{

using Forge = std::function<void(track::Track &)>;

class SavedTrackRules : public testing::Test
{
protected:
    SavedTrackRules() : good_(*test::track_of(test::points_of(10, 2, [](double t) { return glm::dvec2(0, 1.2 * t); })))
    {
    }
    // The refusal of a copy that was forged; "" if it is read.
    std::string said(const Forge &forge) const
    {
        track::Track forged = good_;
        forge(forged);
        track::Array<uint8_t> bytes;
        track::save(forged, bytes);
        track::Track back(std::pmr::get_default_resource());
        try {
            track::load(bytes.data(), bytes.size(), *good_.locomotion, back);
            return "";
        } catch (const base::Error &error) {
            EXPECT_EQ(error.status(), CLQ_FORMAT);
            return error.what();
        }
    }
    // A number in and out of its range.
    template <class Get>
    void range(const std::string &why, const Get &get, const std::vector<double> &inside,
               const std::vector<double> &outside, int line)
    {
        using Number = std::remove_reference_t<decltype(get(good_))>;
        for (const double x : inside)
            EXPECT_EQ(said([&](track::Track &made) { get(made) = static_cast<Number>(x); }), "")
                << "line " << line << ": " << x;
        for (const double x : outside)
            EXPECT_NE(said([&](track::Track &made) { get(made) = static_cast<Number>(x); }).find(why),
                      std::string::npos)
                << "line " << line << ": " << x;
    }
    void refuses(const std::string &why, const Forge &forge)
    {
        const std::string found = said(forge);
        EXPECT_NE(found.find(why), std::string::npos) << found << "\nand not: " << why;
    }

    track::Track good_;
};

#define RANGE(why, get, ...) \
    range(                   \
        why, [&](track::Track & made) -> auto & { return get; }, __VA_ARGS__, __LINE__)

}  // namespace

TEST_F(SavedTrackRules, OfLengthRateAndScale)
{
    const char *const why = "a saved track has a length, rate or scale that no track has";
    const double length_s = good_.length_s;
    for (int k = 0; k < 3; ++k) RANGE(why, made.origin_m[k], {1e300}, {INFINITY, -INFINITY, NAN});
    RANGE(why, made.start_s, {-1e300}, {INFINITY, NAN});
    RANGE(why, made.length_s, {0, length_s}, {-1e-9, 1.001e6, INFINITY, NAN});
    RANGE(why, made.rate_hz, {1}, {0.999, 100.1, INFINITY, NAN});
    RANGE(why, (made.length_s = 0.01, made.rate_hz), {100}, {});
    RANGE(why, made.min_height_m, {-1e300}, {INFINITY, NAN});
    RANGE(why, made.height_step_m, {0, 1}, {-1e-9, INFINITY, NAN});
    RANGE(why, made.metres_per_unit, {1e-9}, {0, -1, INFINITY, NAN});
    RANGE(why, made.scale, {1e-9}, {0, -1, INFINITY, NAN});
    EXPECT_EQ(said([](track::Track &made) {
                  made.length_s = 1e6, made.rate_hz = 1;
                  made.samples.resize(1000001);
              }),
              "");
}

TEST_F(SavedTrackRules, OfSamples)
{
    const size_t steps = good_.samples.size() - 1;
    ASSERT_NEAR(good_.length_s * good_.rate_hz, double(steps), 1e-9);
    refuses("Hz has " + std::to_string(steps) + " samples", [](track::Track &made) { made.samples.pop_back(); });
    for (const size_t count : {1, 2}) {
        const Forge of_a_moment = [=](track::Track &made) { made.length_s = 0, made.samples.resize(count); };
        if (count == 2) EXPECT_EQ(said(of_a_moment), "");
        else refuses("has 1 samples", of_a_moment);
    }
    const char *const lacks = "a saved track plays a gait or clip that its locomotion lacks";
    const track::LocomotionClips &clips = good_.locomotion->clips;
    RANGE(lacks, made.samples[3].gait, {2 * track::gait_unit}, {2 * track::gait_unit + 1});
    RANGE(lacks, made.samples[3].flags, {double((clips.idle_count - 1) << track::idle_shift), 31 << track::turn_shift},
          {double(clips.idle_count << track::idle_shift)});
    // Of a person that can only walk and has no clip to stand with.
    track::LocomotionClips few = clips;
    few.run = few.turn = model::none, few.idle_count = 0;
    track::Locomotion walks(std::pmr::get_default_resource());
    track::measure(*good_.locomotion->tmpl, few, walks);
    const auto points = test::points_of(10, 2, [](double t) { return glm::dvec2(0, 1.1 * t); });
    track::Track made(std::pmr::get_default_resource());
    track::build(walks, {points.data(), static_cast<uint32_t>(points.size())}, {}, made);
    good_ = made;
    RANGE(lacks, made.samples[3].gait, {track::gait_unit}, {track::gait_unit + 1});
    RANGE(lacks, made.samples[3].flags, {track::stands_flag}, {1 << track::idle_shift, 1 << track::turn_shift});
}

TEST_F(SavedTrackRules, OfSteps)
{
    ASSERT_GE(good_.plants[0].size(), 2u);
    ASSERT_GE(good_.plants[1].size(), 2u);
    for (track::Array<track::Plant> &plants : good_.plants) plants.resize(2);
    for (int foot = 0; foot < 2; ++foot) {
        const std::string why = "step 1 of a saved track is impossible";
        const auto plant = [=](track::Track &made) -> track::Plant & { return made.plants[foot][1]; };
        const double before = double(good_.plants[foot][0].end_s), begin = double(plant(good_).begin_s),
                     end = double(plant(good_).end_s);
        RANGE(why, plant(made).begin_s, {before + 1e-3, end}, {before, end + 1e-3, INFINITY, NAN});
        RANGE(why, plant(made).end_s, {begin, 1e30}, {begin - 1e-3, INFINITY, NAN});
        for (float track::Plant::*number :
             {&track::Plant::x, &track::Plant::z, &track::Plant::heading_rad, &track::Plant::begin_x,
              &track::Plant::begin_z, &track::Plant::end_x, &track::Plant::end_z})
            RANGE(why, plant(made).*number, {-1e30}, {INFINITY, NAN});
        const std::string first = "step 0 of a saved track is impossible";
        RANGE(first, made.plants[foot][0].begin_s, {0}, {-1e-3, -INFINITY, NAN});
        // A step may have begun before its piece.
        RANGE(first, (made.previous_hash = 1, made.plants[foot][0].begin_s), {0, -1e3}, {-INFINITY, NAN});
        const std::string swings = "a step of a saved track is impossible";
        for (float track::Swing::*number :
             {&track::Swing::x, &track::Swing::z, &track::Swing::turn_rad, &track::Swing::until_s})
            RANGE(swings, made.swings[foot].*number, {-1e30}, {INFINITY, -INFINITY, NAN});
    }
}

TEST_F(SavedTrackRules, OfShouldersAndGaze)
{
    good_.shoulders = {{1, 0.5f, 0.3f}, {2, 0.5f, -0.3f}};
    const char *const first = "turn 0 of the shoulders", *const second = "turn 1 of the shoulders";
    RANGE(first, made.shoulders[0].at_s, {-1e30}, {-INFINITY, NAN});
    RANGE(first, made.shoulders[0].half_s, {1e-6}, {0, -1, NAN});
    RANGE(second, made.shoulders[1].half_s, {0.5}, {0.51, 0, -1, NAN});
    RANGE(second, (made.shoulders[1].at_s = 100, made.shoulders[1].half_s), {9.99}, {10, INFINITY});
    RANGE(second, made.shoulders[1].at_s, {2, 1e30}, {1.99, INFINITY, NAN});
    RANGE(second, made.shoulders[1].turn_rad, {double(0.6f), -double(0.6f)}, {0.61, -0.61, NAN});
    const char *const gaze = "the gaze of a saved track is impossible";
    RANGE(gaze, made.upper_swing.gaze_rad, {3.99, -3.99}, {4, -4, INFINITY, NAN});
    RANGE(gaze, made.upper_swing.torso_rad, {3.99, -3.99}, {4, -4, INFINITY, NAN});
}

TEST_F(SavedTrackRules, OfHeights)
{
    test::Stairs stairs;
    good_ = *test::track_of(test::climb(stairs, 0.8, false), "citizen", test::settings_for(stairs));
    ASSERT_TRUE(good_.climbs);
    ASSERT_FALSE(good_.sinks.empty());
    const char *const height = "a step of a saved track is at an impossible height";
    for (int foot = 0; foot < 2; ++foot) {
        RANGE(height, made.plants[foot][1].y, {1e6, -1e6, NAN}, {1.001e6, -1.001e6, INFINITY, -INFINITY});
        RANGE(height, made.plants[foot][1].slope, {0, track::max_slope, -track::max_slope},
              {track::max_slope + 1e-5, -track::max_slope - 1e-5, INFINITY, NAN});
        RANGE(height, made.swings[foot].y, {1e6, -1e6}, {1.001e6, -1.001e6, INFINITY, -INFINITY, NAN});
    }
    const double most = track::max_sink * double(good_.locomotion->leg_length) * good_.scale / track::sink_step_m;
    RANGE("the hips of a saved track sink by", made.sinks[4], {0, std::floor(most) + 1}, {std::floor(most) + 2, 65535});
    refuses("of its hips", [](track::Track &made) { made.sinks.pop_back(); });
    refuses("of its hips", [](track::Track &made) { made.sinks.push_back(0); });
    EXPECT_EQ(said([](track::Track &made) { made.sinks.clear(); }), "");
}
