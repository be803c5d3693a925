// The steps that make a fine path, each against its own definition: sums one by one, splines by their Bezier points,
// stands by the speed at each moment, limits of turns by every pair of samples.
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "lib/math/trig.h"
#include "lib/track/build.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

// From 0 on and below 1, of no pattern.
double number(uint64_t i) { return double((i * 0x9e3779b97f4a7c15u ^ i) >> 11) / double(uint64_t(1) << 53); }

base::Span<const track::Point> span(const std::vector<track::Point> &points)
{
    return {points.data(), static_cast<uint32_t>(points.size())};
}

// A path at 50 samples a second, of which x(i) is given; z falls half as much.
track::FinePath path_of(uint32_t count, const std::function<double(uint32_t)> &x)
{
    track::FinePath path(std::pmr::get_default_resource());
    path.x.resize(count), path.y.resize(count), path.z.resize(count);
    for (uint32_t i = 0; i < count; ++i)
        path.x[i] = x(i), path.z[i] = -0.5 * path.x[i], path.y[i] = 2 + 0.1 * path.x[i];
    path.last = count - 1;
    return path;
}

}  // namespace

TEST(FinePath, IsSmoothedByTheMeanOfWhatLiesBeside)
{
    for (const uint32_t count : {1u, 2u, 3u, 9u, 40u})
        for (const uint32_t half : {0u, 1u, 4u, 13u})
            for (const track::Beyond beyond : {track::Beyond::mirrored, track::Beyond::still}) {
                track::Array<double> values;
                for (uint32_t i = 0; i < count + 5; ++i) values.push_back(1e6 + number(i));
                track::Array<double> smoothed = values;
                const uint32_t first = 2, last = first + count - 1;
                track::smooth(smoothed, first, last, half, beyond);
                const auto at = [&](int64_t i) {
                    const int64_t inside = std::clamp<int64_t>(i, first, last);
                    const double end = values[size_t(inside)];
                    if (i == inside || beyond == track::Beyond::still) return end;
                    return 2 * end - values[size_t(std::clamp<int64_t>(2 * inside - i, first, last))];
                };
                for (uint32_t i = 0; i < values.size(); ++i) {
                    double sum = 0;
                    for (int64_t k = int64_t(i) - half; k <= int64_t(i) + half; ++k) sum += at(k) - 1e6;
                    const bool is_inside = i >= first && i <= last && count > 2;
                    ASSERT_NEAR(smoothed[i] - 1e6, is_inside ? sum / (2 * half + 1) : values[i] - 1e6, 1e-8)
                        << count << ", " << half << ", " << i;
                }
            }
}

TEST(FinePath, HasAWholeNumberOfStepsFromItsFirstPointToItsLast)
{
    for (const double length : {0.0, 0.01, 0.4, 0.401, 7.3, 61.0}) {
        track::FinePath path(std::pmr::get_default_resource());
        track::make_grid(span({{3, glm::dvec3(0), 0}, {3 + length, glm::dvec3(0), 0}}), path);
        const uint32_t steps = path.count() - 1;
        EXPECT_EQ(steps % track::fine_multiple, 0u);
        EXPECT_GE(steps, track::fine_multiple);
        EXPECT_EQ(path.start_s, 3);
        EXPECT_EQ(path.first, 0u);
        EXPECT_EQ(path.last, steps);
        if (length > 0) EXPECT_NEAR(steps / path.hz, length, 1e-9);
        // As few as give fine_hz.
        EXPECT_GE(steps, length * track::fine_hz - 1e-9);
        EXPECT_TRUE(steps == track::fine_multiple || steps - track::fine_multiple < length * track::fine_hz) << length;
    }
}

// Between points a Bezier curve, whose inner points lie on the tangents of its ends; where more than 2.5 s pass from
// one point to the next, nothing is known but the straight way.
TEST(FinePath, GoesThroughItsPointsOnCurvesWithoutCorners)
{
    std::vector<track::Point> points;
    double t = 5;
    for (uint64_t i = 0; i < 40; ++i) {
        points.push_back({t, glm::dvec3(10 * number(3 * i), number(3 * i + 1), 10 * number(3 * i + 2)), NAN});
        t += i % 7 == 3 ? 2.51 + number(i) : i % 7 == 5 ? 2.49 : 0.2 + number(i);
    }
    const auto gap = [&](size_t i) { return points[i + 1].time_s - points[i].time_s; };
    const auto way = [&](size_t i) { return (points[i + 1].position - points[i].position) / gap(i); };
    const auto is_known = [&](size_t i) { return i + 1 < points.size() && gap(i) <= 2.5; };
    // A parabola through a point and its two neighbours has this slope there.
    const auto tangent = [&](size_t i) {
        const bool before = i > 0 && is_known(i - 1), after = is_known(i);
        if (before && after) return (way(i - 1) * gap(i) + way(i) * gap(i - 1)) / (gap(i - 1) + gap(i));
        return after ? way(i) : way(i - 1);
    };
    track::BuildSettings settings;
    settings.smooth_s = 0, settings.metres_per_unit = 0.5;
    track::FinePath path(std::pmr::get_default_resource());
    track::make_grid(span(points), path);
    const glm::dvec3 origin(1, 2, 3);
    track::make_path(span(points), settings, origin, path);
    for (uint32_t k = 0; k < path.count(); ++k) {
        const double time_s = std::min(path.start_s + k / path.hz, points.back().time_s);
        size_t i = 0;
        while (i + 2 < points.size() && points[i + 1].time_s <= time_s) ++i;
        const double u = (time_s - points[i].time_s) / gap(i), v = 1 - u;
        const glm::dvec3 a = points[i].position, d = points[i + 1].position;
        glm::dvec3 wanted = a * v + d * u;
        if (is_known(i)) {
            const glm::dvec3 b = a + tangent(i) * (gap(i) / 3), c = d - tangent(i + 1) * (gap(i) / 3);
            wanted = a * (v * v * v) + b * (3 * v * v * u) + c * (3 * v * u * u) + d * (u * u * u);
        }
        wanted = wanted * 0.5 - origin;
        ASSERT_NEAR(path.x[k], wanted.x, 1e-9) << time_s;
        ASSERT_NEAR(path.y[k], wanted.y, 1e-9) << time_s;
        ASSERT_NEAR(path.z[k], wanted.z, 1e-9) << time_s;
    }
}

TEST(FinePath, HasTheSpeedOfTheSamplesBesideEachAndNoneWhereItStands)
{
    for (const uint32_t count : {1u, 3u, 5u, 30u}) {
        track::FinePath path = path_of(count, [](uint32_t i) { return number(i); });
        path.stands.assign(count, 0);
        if (count > 9) path.stands[9] = 1;
        track::measure_speed(path);
        for (uint32_t i = 0; i < count; ++i) {
            // An end has the speed of the sample beside it.
            const uint32_t at = count == 1 ? 0 : std::clamp(i, 1u, count - 2), most = at == i ? 3 : 1;
            const uint32_t reach = std::min({most, at, count - 1 - at});
            const double x = path.x[at + reach] - path.x[at - reach], z = path.z[at + reach] - path.z[at - reach];
            const double speed = reach > 0 ? std::hypot(x, z) / (2 * reach) * path.hz : 0;
            ASSERT_NEAR(path.speed[i], i == 9 ? 0 : speed, 1e-9) << count << ", " << i;
        }
    }
}

// Whatever the speeds: who stands is still, has been slow, and is near the given path; pieces cover the rest.
TEST(FinePath, StandsOnlyWhereItIsSlowAndNearTheGivenPath)
{
    constexpr double speeds[] = {0, 0.05, 0.18, 0.3, 1.2};
    uint32_t standing = 0;
    for (uint64_t seed = 0; seed < 30; ++seed) {
        const uint32_t count = 1500;
        double x = 0;
        uint32_t left = 0;
        double speed = 0;
        track::FinePath path = path_of(count, [&](uint32_t i) {
            if (left-- == 0) {
                left = 60 + static_cast<uint32_t>(140 * number(7 * i + seed));
                speed = speeds[static_cast<size_t>(5 * number(11 * i + seed))];
            }
            return x += speed / 50;
        });
        const track::FinePath given = path;
        track::find_stands({}, path);
        for (uint32_t i = 0; i < count; ++i) {
            const double away = std::hypot(path.x[i] - given.x[i], path.z[i] - given.z[i]);
            ASSERT_LE(away, 0.35) << i << ", " << seed;
            if (!path.stands[i]) continue;
            ++standing;
            ASSERT_EQ(path.speed[i], 0);
            const uint32_t reach = std::min({12u, i, count - 1 - i});
            const double way =
                std::hypot(given.x[i + reach] - given.x[i - reach], given.z[i + reach] - given.z[i - reach]);
            if (reach > 0) {
                ASSERT_LE(way / (2 * reach) * 50, 0.25 + 1e-9) << i << ", " << seed;
            }
            if (i > 0 && path.stands[i - 1]) {
                ASSERT_NEAR(path.x[i], path.x[i - 1], 1e-12) << i;
                ASSERT_NEAR(path.y[i], path.y[i - 1], 1e-12) << i;
                ASSERT_NEAR(path.z[i], path.z[i - 1], 1e-12) << i;
            }
        }
        // A piece ends within a stand, seven samples from where it is at rest, or at an end of the path.
        std::vector<uint8_t> covered(count, 0);
        for (const track::FinePath::Piece &piece : path.pieces) {
            ASSERT_LT(piece.first, piece.last);
            for (uint32_t i = 0; i < count; ++i) covered[i] |= i + 7 >= piece.first && i <= piece.last + 7;
            if (piece.first > 0) {
                ASSERT_TRUE(path.stands[piece.first - 7]) << seed;
            }
            if (piece.last + 1 < count) {
                ASSERT_TRUE(path.stands[piece.last + 7]) << seed;
            }
        }
        for (uint32_t i = 7; i + 7 < count; ++i) ASSERT_TRUE(covered[i] || path.stands[i]) << i << ", " << seed;
    }
    EXPECT_GT(standing, 3000u);
}

// A stand lasts from the first sample below a tenth of a metre a second to the last before a quarter, seven less at
// either end: to the sample.
TEST(FinePath, StandsToTheSample)
{
    for (uint32_t shift = 0; shift < 9; ++shift) {
        const uint32_t from = 200 + shift, to = 420 + 3 * shift, count = 700;
        track::FinePath path = path_of(count, [&](uint32_t i) {
            return 0.8 / 50 * (double(std::min(i, from)) + (i > to ? double(i - to) : 0.0));
        });
        for (uint32_t i = 0; i < count; ++i) path.z[i] = 0;
        uint32_t begin = 0, end = 0;  // by the mean speed within half a second
        const auto speed = [&](uint32_t i) { return (path.x[i + 12] - path.x[i - 12]) / 24 * 50; };
        for (uint32_t i = 12; i + 12 < count; ++i) {
            if (begin == 0 && speed(i) < 0.1) begin = i;
            if (begin > 0 && end == 0 && speed(i) > 0.25) end = i - 1;
        }
        track::find_stands({}, path);
        for (uint32_t i = 0; i < count; ++i)
            ASSERT_EQ(path.stands[i] != 0, i >= begin + 7 && i + 7 <= end) << i << " of " << begin << " to " << end;
    }
}

TEST(FinePath, TurnsNoFasterThanItMayAndAsLittleOffAsThatAllows)
{
    const uint32_t count = 400;
    std::vector<track::Point> points;
    for (uint32_t i = 0; i < count; ++i) {
        const double jump = i / 60 % 2 ? 1.5 : 0.0, calm = 0.4 * std::sin(0.01 * i);
        points.push_back({i / 50.0, glm::dvec3(0.03 * i, 0, 0), i < 250 ? jump : calm});
    }
    for (const double most : {0.5, 3.1}) {
        track::FinePath path = path_of(count, [](uint32_t i) { return 0.03 * i; });
        path.stands.assign(count, 0);
        track::BuildSettings settings;
        settings.max_turn_rad_s = most;
        track::make_heading(span(points), settings, path);
        ASSERT_EQ(path.heading.size(), count);
        for (uint32_t i = 1; i < count; ++i) {
            ASSERT_LE(std::fabs(path.heading[i] - path.heading[i - 1]) * 50, most * (1 + 1e-9)) << i;
            ASSERT_NEAR(path.turn[i], std::fabs(path.heading[i] - path.heading[i - 1]) * 50, 1e-9);
        }
        // Half way between the lowest line above and the highest below that turn as fast as they may, and smoothed over
        // six samples to either side.
        track::Array<double> wanted(count, 0.0);
        for (uint32_t i = 0; i < count; ++i) {
            double above = 1e9, below = -1e9;
            for (uint32_t k = 0; k < count; ++k) {
                const double reach = most / 50 * std::fabs(double(i) - k);
                above = std::min(above, points[k].heading_rad + reach);
                below = std::max(below, points[k].heading_rad - reach);
            }
            wanted[i] = (above + below) / 2;
        }
        track::smooth(wanted, 0, count - 1, 6, track::Beyond::mirrored);
        for (uint32_t i = 0; i < count; ++i) ASSERT_NEAR(path.heading[i], wanted[i], 1e-9) << i;
    }
}

TEST(FinePath, TurnsByTheShorterWay)
{
    for (double angle = -20; angle < 20; angle += 0.37)
        for (double to = -9; to < 9; to += 0.41) {
            const double found = track::nearest_turn(angle, to);
            EXPECT_LE(std::fabs(found - to), math::pi + 1e-9);
            EXPECT_NEAR(std::remainder(found - angle, 2 * math::pi), 0, 1e-9);
        }
}

// The hips sink by as much as brings the straight leg to the tread, by the theorem of Pythagoras.
TEST(FinePath, SinksByWhatTheLegWants)
{
    const double leg = 0.9;
    for (double reach = 0; reach < 0.9; reach += 0.1)
        for (double flat = 0; flat < 1.0; flat += 0.09)
            for (double below = 0; below < 0.4; below += 0.07) {
                const double sink = track::sink_wanted(leg, reach, flat, below);
                ASSERT_GE(sink, 0);
                ASSERT_LE(sink, below);
                // The hip's height over level ground is that at which the straight leg reaches so far.
                const double hip = std::sqrt(leg * leg - reach * reach) + below - sink;
                const double away = std::hypot(hip, flat), bent = 0.985 * leg;
                if (sink > 0 && sink < below && flat < bent) ASSERT_NEAR(away, bent, 1e-9);
                if (sink == 0 && below > 0) ASSERT_LE(away, bent + 1e-9);
            }
}
