// Where people look and how they turn their shoulders, computed from what they will do; and passings of straight ways,
// whose nearest moment is a quotient.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lib/math/trig.h"
#include "lib/track/passings.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

double to_shorter(double a) { return std::remainder(a, 2 * math::pi); }

double smoothly(double part)
{
    part = std::clamp(part, 0.0, 1.0);
    return part * part * (3 - 2 * part);
}

// Headings of no pattern, four a second; `ahead` of them lie behind the end.
track::Track looking_about(uint32_t samples, uint32_t ahead)
{
    track::Track track(std::pmr::get_default_resource());
    track.locomotion = &test::locomotion_of("citizen");
    track.start_s = 10, track.rate_hz = 4, track.length_s = (samples - 1) / 4.0;
    uint64_t state = samples + 7 * ahead;
    for (uint32_t i = 0; i < samples + ahead; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        const auto heading = static_cast<uint16_t>(state >> 40);
        if (i < samples) track.samples.emplace_back().heading = heading;
        else track.ahead.push_back(heading);
    }
    return track;
}

// The heading at a time, also behind the end, where the last one that is known stays.
double heading_of(const track::Track &track, double time_s)
{
    std::vector<double> all;
    for (const track::Sample &sample : track.samples) all.push_back(2 * math::pi * sample.heading / 65536);
    for (const uint16_t heading : track.ahead) all.push_back(2 * math::pi * heading / 65536);
    const double at = std::clamp((time_s - track.start_s) * track.rate_hz, 0.0, double(all.size() - 1));
    const size_t i = std::min(static_cast<size_t>(at), all.size() - 2);
    return all[i] + to_shorter(all[i + 1] - all[i]) * (at - double(i));
}

}  // namespace

TEST(GazeLaw, IsTheMeanOfTheTurnsAheadAndNeverMoreThanANeckTurns)
{
    for (const uint32_t ahead : {0u, 1u, 3u}) {
        const track::Track track = looking_about(21, ahead);
        for (double t = 9; t < 17; t += 0.0371) {
            const track::State state = track::state_at(track, t);
            double mean = 0;
            for (const double later : {0.35, 0.75})
                mean += 0.5 * to_shorter(heading_of(track, t + later) - state.heading_rad);
            const double wanted = mean / std::sqrt(1 + mean * mean / (1.1 * 1.1));
            ASSERT_NEAR(track::upper_at(track, state, t).gaze_rad, wanted, 1e-4) << ahead << " at " << t;
        }
    }
}

TEST(GazeLaw, OfAPieceFadesFromThatOfThePieceBefore)
{
    track::Track whole = looking_about(21, 2), piece = whole;
    piece.previous_hash = 9, piece.upper_swing.gaze_rad = 0.5f, piece.upper_swing.torso_rad = -0.25f;
    for (double t = 10; t < 12; t += 0.0371) {
        const track::State state = track::state_at(whole, t);
        const pose::UpperTarget own = track::upper_at(whole, state, t), shown = track::upper_at(piece, state, t);
        const double left = 1 - smoothly((t - 10) / 0.6);
        ASSERT_NEAR(shown.gaze_rad - own.gaze_rad, 0.5 * left, 1e-5) << t;
        ASSERT_NEAR(shown.torso_rad - own.torso_rad, -0.25 * left, 1e-5) << t;
    }
}

TEST(ShoulderLaw, TurnAboutEachMomentAndNotBetweenThem)
{
    track::Track track = looking_about(41, 0);
    track.shoulders = {{0.5f, 0.4f, 0.3f}, {2.0f, 0.65f, -0.5f}, {2.9f, 0.25f, 0.2f}, {9.9f, 0.65f, 0.4f}};
    track::index_plants(track);
    for (double gone = -0.5; gone < 11; gone += 0.0093) {
        double wanted = 0;
        for (const track::ShoulderTurn &turn : track.shoulders)
            if (gone > 0 && std::fabs(gone - double(turn.at_s)) < double(turn.half_s))
                wanted =
                    double(turn.turn_rad) * smoothly(1 - std::fabs(gone - double(turn.at_s)) / double(turn.half_s));
        const double t = 10 + gone;
        ASSERT_NEAR(track::upper_at(track, track::state_at(track, t), t).torso_rad, wanted, 1e-5) << gone;
    }
}

TEST(PassingLaw, OfStraightWaysIsWhereTheyAreNearest)
{
    int passed = 0, apart = 0, together = 0;
    uint64_t state = 5;
    const auto number = [&](double least, double most) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return least + (most - least) * double(state >> 40) / double(1 << 24);
    };
    for (int i = 0; i < 3000; ++i) {
        const double unit = i % 2 ? 0.5 : 1;
        // Both ways cross near a place at a time; metres.
        const double crosses_s = number(-1, 9), cx = number(-50, 50), cz = number(-50, 50);
        glm::dvec3 at[2], v[2];
        std::vector<track::Point> points[2];
        for (int k = 0; k < 2; ++k) {
            v[k] = glm::dvec3(number(-1.5, 1.5), 0, number(-1.5, 1.5));
            at[k] = glm::dvec3(cx + number(-0.8, 0.8), k, cz + number(-0.8, 0.8));
            const double begins_s = number(-0.5, 0.5), ends_s = number(7.5, 8.5);
            for (const double t : {begins_s, number(3, 5), ends_s})
                points[k].push_back({t, (at[k] + v[k] * (t - crosses_s)) / unit, 0});
        }
        const base::Span<const track::Point> people[] = {{points[0].data(), 3}, {points[1].data(), 3}};
        track::Array<track::FoundPassing> found;
        track::find_passings({people, 2}, unit, found);
        const glm::dvec3 d(at[1].x - at[0].x, 0, at[1].z - at[0].z), w = v[1] - v[0];
        const double square = w.x * w.x + w.z * w.z, away_s = -(d.x * w.x + d.z * w.z) / square;
        const double time_s = crosses_s + away_s, nearest = std::hypot(d.x + w.x * away_s, d.z + w.z * away_s);
        // They are seen five times a second, and have to be there before and after.
        const double first_s = std::max(points[0][0].time_s, points[1][0].time_s),
                     last_s = std::min(points[0][2].time_s, points[1][2].time_s);
        const bool close = nearest < 1, fast = std::sqrt(square) >= 0.6;
        if (time_s > first_s + 0.5 && time_s < last_s - 0.5 && close && fast) {
            ++passed;
            ASSERT_EQ(found.size(), 2u) << i;
            for (uint32_t k = 0; k < 2; ++k) {
                const track::Passing &one = found[k].passing;
                EXPECT_EQ(found[k].person, k);
                ASSERT_NEAR(one.time_s, time_s, 1e-6) << i;
                const glm::dvec3 other = at[1 - k] + v[1 - k] * away_s;
                ASSERT_NEAR(one.position.x * unit, other.x, 1e-6) << i;
                ASSERT_NEAR(one.position.z * unit, other.z, 1e-6) << i;
            }
        } else if (!close || !fast || time_s < first_s - 0.01 || time_s > last_s + 0.01) {
            ASSERT_TRUE(found.empty()) << i << ": " << nearest << " m, " << std::sqrt(square) << " m/s";
            apart += !close, together += !fast;
        }
    }
    EXPECT_GT(passed, 500);
    EXPECT_GT(apart, 100);
    EXPECT_GT(together, 100);
}
