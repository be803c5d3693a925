// A track gives back the path that it was made of.
#include "lib/track/track.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

double away(const track::Track &track, const track::Point &point)
{
    const glm::dvec3 d = track::position_at(track, point.time_s) - point.position;
    return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

glm::dvec2 winding(double t) { return glm::dvec2(1.3 * t, 2 * std::sin(0.7 * t)); }

void expect_refused(const std::vector<track::Point> &points, clq_status status, const char *words,
                    const track::BuildSettings &settings = {})
{
    try {
        test::track_of(points, "citizen", settings);
        ADD_FAILURE() << "accepted, not refused with '" << words << "'";
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), status);
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

}  // namespace

TEST(Track, IsWithinAMillimetreOfThePointsIfItIsNotSmoothed)
{
    track::BuildSettings settings;
    settings.smooth_s = 0;
    for (const double rate : {2.5, 10.0, 16.0, 25.0}) {
        const std::vector<track::Point> points = test::points_of(rate, 40, winding);
        const auto track = test::track_of(points, "citizen", settings);
        for (const track::Point &point : points)
            ASSERT_LT(away(*track, point), 0.001) << rate << " at " << point.time_s;
    }
}

TEST(Track, HasAsManySamplesAsItsTurnsNeed)
{
    track::BuildSettings settings;
    settings.smooth_s = 0;
    const auto dodging = [](double t) { return glm::dvec2(1.3 * t, 0.05 * std::sin(12 * t)); };
    const std::vector<track::Point> points = test::points_of(25, 20, dodging);
    const auto quick = test::track_of(points, "citizen", settings);
    const auto calm = test::track_of(test::points_of(25, 20, winding), "citizen", settings);
    EXPECT_GE(quick->samples.size(), 2 * calm->samples.size() - 1);
    for (const track::Point &point : points) ASSERT_LT(away(*quick, point), 0.001) << point.time_s;
}

TEST(Track, KeepsItsEnds)
{
    const std::vector<track::Point> points = test::points_of(10, 33.3, winding);
    const auto track = test::track_of(points);
    EXPECT_LT(away(*track, points.front()), 0.001);
    EXPECT_LT(away(*track, points.back()), 0.001);
    EXPECT_EQ(track->start_s, points.front().time_s);
    EXPECT_DOUBLE_EQ(track->start_s + track->length_s, points.back().time_s);
}

TEST(Track, KeepsMillimetresAMillionMetresFromTheOriginAndUpstairs)
{
    track::BuildSettings settings;
    settings.smooth_s = 0;
    std::vector<track::Point> points = test::points_of(10, 30, winding);
    for (track::Point &point : points) point.position += glm::dvec3(1e6, 100 + 0.3 * point.time_s, -2e6);
    const auto track = test::track_of(points, "citizen", settings);
    for (const track::Point &point : points) ASSERT_LT(away(*track, point), 0.001);
}

TEST(Track, IsNeverFasterThanItsTopSpeedAndNearlyReachesIt)
{
    for (const double unit : {1.0, 0.5}) {
        track::BuildSettings settings;
        settings.metres_per_unit = unit;
        const auto track = test::track_of(test::points_of(10, 40, winding), "citizen", settings);
        double most = 0;
        for (double t = -1; t < 41; t += 0.001) {
            const glm::dvec3 d = track::position_at(*track, t + 0.001) - track::position_at(*track, t);
            most = std::fmax(most, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) / 0.001);
        }
        EXPECT_LE(most, track->top_speed * (1 + 1e-6)) << unit;
        EXPECT_GT(most, 0.8 * track->top_speed) << unit;
    }
}

TEST(Track, IsTheSameInOtherUnits)
{
    std::vector<track::Point> points = test::points_of(10, 20, winding), in_feet = points;
    for (track::Point &point : in_feet) point.position /= 0.3048;
    track::BuildSettings feet;
    feet.metres_per_unit = 0.3048, feet.scale = 1 / 0.3048;
    const auto a = test::track_of(points), b = test::track_of(in_feet, "citizen", feet);
    for (double t = 0; t < 20; t += 0.1) {
        const track::State x = track::state_at(*a, t), y = track::state_at(*b, t);
        ASSERT_NEAR(x.position.x, y.position.x * 0.3048, 1e-3);
        ASSERT_NEAR(x.position.z, y.position.z * 0.3048, 1e-3);
        ASSERT_NEAR(x.gait, y.gait, 0.02);
    }
}

TEST(Track, HasSixteenBytesASampleAndFewSamples)
{
    const auto track = test::track_of(test::points_of(10, 100, winding));
    EXPECT_LE(track->samples.size(), 1260u);
    EXPECT_LE(track->bytes(), sizeof(track::Track) + 16 * track->samples.capacity() + 40 * 500 + 8 * 102);
}

TEST(Track, FindsAStepInConstantTimeEvenAfterTwoHours)
{
    const auto track = test::track_of(
        test::points_of(2.5, 7200, [](double t) { return glm::dvec2(30 * std::cos(t / 25), 30 * std::sin(t / 25)); }));
    for (int f = 0; f < 2; ++f) {
        const auto &first = track->first_plants[f];
        ASSERT_EQ(first.size(), 7201u);
        // What a search from a second's first step walks over is at most what begins in two seconds.
        for (size_t s = 2; s < first.size(); ++s) ASSERT_LE(first[s] - first[s - 2], 5u) << s;
    }
    track::State late = track::state_at(*track, 7100.01);
    EXPECT_NEAR(late.position.x, 30 * std::cos(7100.01 / 25), 0.05);
    EXPECT_TRUE(track::foot_at(*track, late, 0, 7100.01).planted || track::foot_at(*track, late, 1, 7100.01).planted);
}

TEST(Track, OfOnePointStands)
{
    const auto track = test::track_of({{3, glm::dvec3(1, 2, 4), std::nan("")}});
    EXPECT_TRUE(track::is_present(*track, 3));
    EXPECT_FALSE(track::is_present(*track, 2.99));
    EXPECT_FALSE(track::is_present(*track, 3.01));
    EXPECT_EQ(track::position_at(*track, 3), glm::dvec3(1, 2, 4));
}

TEST(Track, OfPointsThatMeanNothingIsRefusedWithTheirNumber)
{
    const std::vector<track::Point> good = test::points_of(10, 1, winding);
    expect_refused({}, CLQ_ARGUMENT, "no points");
    std::vector<track::Point> bad = good;
    bad[3].time_s = bad[2].time_s;
    expect_refused(bad, CLQ_ARGUMENT, "point 3");
    bad = good, bad[4].position.y = INFINITY;
    expect_refused(bad, CLQ_ARGUMENT, "position of point 4");
    bad = good, bad[5].time_s = std::nan("");
    expect_refused(bad, CLQ_ARGUMENT, "time of point 5");
    bad = good, bad[9].position.x = 3e5;
    expect_refused(bad, CLQ_LIMIT, "point 9");
    bad = good, bad.back().time_s = 2e6;
    expect_refused(bad, CLQ_LIMIT, "1e+06 s");
    track::BuildSettings settings;
    settings.smooth_s = -1;
    expect_refused(good, CLQ_ARGUMENT, "smooth_s", settings);
    settings = {}, settings.scale = 0;
    expect_refused(good, CLQ_ARGUMENT, "scale", settings);
}

TEST(Track, TakesAnyTimesAndPlacesWithoutHarm)
{
    for (uint64_t seed = 1; seed < 40; ++seed) {
        uint64_t bits = seed;
        const auto number = [&bits] {
            return double((bits = bits * 6364136223846793005u + 1442695040888963407u) >> 33) / (1u << 30);
        };
        std::vector<track::Point> points;
        double t = -5 * number();
        const int count = 1 + int(40 * number());
        for (int i = 0; i < count; ++i) {
            t += 1e-6 + number() * number() * 4;
            points.push_back(
                {t, glm::dvec3(30 * number(), number(), 30 * number()), i % 3 ? std::nan("") : 9 * number()});
        }
        const auto track = test::track_of(points);
        std::vector<double> times = {-1.7e308, 1.7e308};
        for (double at = t - 60; at < t + 2; at += 0.37) times.push_back(at);
        for (const double at : times) {
            const track::State state = track::state_at(*track, at);
            ASSERT_TRUE(std::isfinite(state.position.x) && std::isfinite(state.heading_rad) &&
                        std::isfinite(state.phase));
            ASSERT_TRUE(state.gait >= 0 && state.gait <= 2);
            for (int f = 0; f < 2; ++f) {
                const pose::FootTarget foot = track::foot_at(*track, state, f, at);
                ASSERT_TRUE(std::isfinite(foot.x) && std::isfinite(foot.z) && std::fabs(foot.turn_rad) < 0.8f);
            }
        }
    }
}
