// A track of any samples against what they mean: positions on curves whose slope is the speed, angles by the shorter
// way, boxes and bounds by the points of Bezier, feet where their plants are.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lib/math/trig.h"
#include "tests/unit/track/made_tracks.h"

using namespace claque;

namespace
{

constexpr uint64_t seeds = 12;

class Bits  // of no pattern
{
public:
    explicit Bits(uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1) {}
    uint32_t next(uint32_t below)
    {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<uint32_t>((state_ >> 33) % below);
    }

private:
    uint64_t state_;
};

// Samples, plants and scales of no pattern; some samples stand with the one before them.
track::Track any_track(uint64_t seed)
{
    track::Track track(std::pmr::get_default_resource());
    Bits bits(seed);
    track.locomotion = &test::locomotion_of("citizen");
    track.origin_m = glm::dvec3(7, -3, 1000);
    track.start_s = 100, track.rate_hz = 8, track.length_s = 2.5;  // times of samples are exact
    track.min_height_m = 1.5, track.height_step_m = 1e-4;
    track.metres_per_unit = seed % 2 ? 0.5 : 1, track.scale = 1.25;
    for (int i = 0; i <= 20; ++i) {
        track::Sample sample;
        if (i > 0) sample = track.samples.back();
        // Who has moved since it stood stands no sooner than a sample later: between two that stand nothing moves.
        const auto stood = [&](int k) { return k >= 0 && track.samples[size_t(k)].flags & track::stands_flag; };
        const bool stands = i > 0 && bits.next(3) == 0 && (stood(i - 1) || !stood(i - 2));
        if (!stands) {
            sample.x += static_cast<int32_t>(bits.next(4000)) - 2000;
            sample.z += static_cast<int32_t>(bits.next(4000)) - 2000;
            sample.height = static_cast<uint16_t>(bits.next(65536));
            sample.heading = static_cast<uint16_t>(bits.next(65536));
            sample.phase = static_cast<uint16_t>(bits.next(65536));
            sample.gait = static_cast<uint8_t>(bits.next(255));
        }
        sample.flags = static_cast<uint8_t>(bits.next(3) << track::idle_shift | bits.next(32) << track::turn_shift);
        if (stands) {
            sample.flags |= track::stands_flag;
            track.samples.back().flags |= track::stands_flag;
        }
        track.samples.push_back(sample);
    }
    for (int foot = 0; foot < 2; ++foot) {
        float at = 0.05f * static_cast<float>(1 + foot);
        while (at < 2.4f) {
            track::Plant plant;
            plant.begin_s = at, plant.end_s = at + 0.1f + 0.002f * static_cast<float>(bits.next(100));
            for (float track::Plant::*number :
                 {&track::Plant::x, &track::Plant::z, &track::Plant::heading_rad, &track::Plant::begin_x,
                  &track::Plant::begin_z, &track::Plant::end_x, &track::Plant::end_z})
                plant.*number = 0.001f * static_cast<float>(bits.next(2000)) - 1;
            if (seed % 3 == 0) plant.y = 2 + 0.001f * static_cast<float>(bits.next(1000));
            track.plants[foot].push_back(plant);
            at = plant.end_s + 0.05f + 0.003f * static_cast<float>(bits.next(100));
        }
    }
    track::index_plants(track);
    track.top_speed = track::top_speed_of(track);
    track.reach = track::reach_of(track);
    return track;
}

bool stands(const track::Track &track, size_t i) { return track.samples[i].flags & track::stands_flag; }

double shorter(double a) { return std::remainder(a, 2 * math::pi); }

}  // namespace

TEST(AnyTrack, IsItsSampleAtTheTimeOfEach)
{
    for (uint64_t seed = 1; seed < seeds; ++seed) {
        const track::Track track = any_track(seed);
        for (size_t i = 0; i < track.samples.size(); ++i) {
            const track::Sample &sample = track.samples[i];
            const double time_s = 100 + double(i) / 8;
            const track::State state = track::state_at(track, time_s);
            const glm::dvec3 metres(7 + sample.x / 8192.0, -3 + 1.5 + sample.height * 1e-4, 1000 + sample.z / 8192.0);
            const glm::dvec3 p = state.position * track.metres_per_unit;
            for (int k = 0; k < 3; ++k) {
                ASSERT_NEAR(p[k], metres[k], 1e-9) << i;
                ASSERT_NEAR(track::position_at(track, time_s)[k], state.position[k], 1e-12) << i;
                ASSERT_NEAR(track::motion_at(track, time_s).position[k], state.position[k], 1e-12) << i;
            }
            EXPECT_NEAR(shorter(state.heading_rad - 2 * math::pi * sample.heading / 65536), 0, 1e-9);
            EXPECT_NEAR(state.phase - std::floor(state.phase + 1e-12), sample.phase / 65536.0, 1e-9);
            EXPECT_NEAR(state.gait, sample.gait / 127.0, 1e-6);
            EXPECT_NEAR(state.turn, (sample.flags >> 3) / 31.0, 1e-6);
            if (i + 1 < track.samples.size()) {
                EXPECT_EQ(state.idle, track::idle_of(sample.flags));
                EXPECT_EQ(state.stands, stands(track, i) && stands(track, i + 1));
            }
        }
    }
}

TEST(AnyTrack, GoesFromSampleToSampleByTheShorterWay)
{
    for (uint64_t seed = 1; seed < seeds; ++seed) {
        const track::Track track = any_track(seed);
        for (size_t i = 0; i + 1 < track.samples.size(); ++i)
            for (const double part : {0.25, 0.5, 0.8}) {
                const track::Sample &a = track.samples[i], &b = track.samples[i + 1];
                const track::State state = track::state_at(track, 100 + (double(i) + part) / 8);
                const auto between = [&](double from, double to) { return from + (to - from) * part; };
                const double from = 2 * math::pi * a.heading / 65536, turn = 2 * math::pi * b.heading / 65536 - from;
                EXPECT_NEAR(shorter(state.heading_rad - from - shorter(turn) * part), 0, 1e-9) << i;
                const double cycles = std::remainder((b.phase - a.phase) / 65536.0, 1.0);
                EXPECT_NEAR(std::remainder(state.phase - a.phase / 65536.0 - cycles * part, 1.0), 0, 1e-9) << i;
                EXPECT_NEAR(state.gait, between(a.gait, b.gait) / 127, 1e-6);
                EXPECT_NEAR(state.turn, between(a.flags >> 3, b.flags >> 3) / 31, 1e-6);
            }
    }
}

TEST(AnyTrack, HasTheSpeedOfItsPositionsAndTheirSlopesJoin)
{
    for (uint64_t seed = 1; seed < seeds; ++seed) {
        const track::Track track = any_track(seed);
        constexpr double h = 1e-5;
        const auto slope = [&](double t) {
            return (track::position_at(track, t + h) - track::position_at(track, t - h)) / (2 * h);
        };
        for (double t = 100.003; t < 102.5; t += 0.0107) {
            if (std::fabs(std::remainder((t - 100) * 8, 1)) < 1e-3) continue;  // slopes change there
            const track::Motion motion = track::motion_at(track, t);
            const glm::dvec3 v = slope(t);
            ASSERT_NEAR(motion.speed, std::hypot(v.x, v.z), 1e-4) << t;
            const double turn =
                shorter(track::motion_at(track, t + h).heading_rad - track::motion_at(track, t - h).heading_rad) /
                (2 * h);
            // Limbs reach 0.3 of a leg's length from the axis of the body.
            const double limb = 0.3 * double(track.locomotion->leg_length) * track.scale / track.metres_per_unit;
            ASSERT_NEAR(motion.limb_speed - motion.speed, std::fabs(turn) * limb, 1e-3) << t;
            ASSERT_LE(std::hypot(v.x, std::hypot(v.y, v.z)), track.top_speed * (1 + 1e-6)) << t;
        }
        // A sample that stands has no slope; the others have that from the sample before to the sample behind.
        constexpr double g = 1e-6;
        for (size_t i = 1; i + 1 < track.samples.size(); ++i) {
            const double t = 100 + double(i) / 8;
            const glm::dvec3 before = track::position_at(track, t) - track::position_at(track, t - g),
                             after = track::position_at(track, t + g) - track::position_at(track, t);
            const glm::dvec3 way = stands(track, i)
                                       ? glm::dvec3(0)
                                       : track::position_at(track, t + 0.125) - track::position_at(track, t - 0.125);
            for (int k = 0; k < 3; ++k) {
                ASSERT_NEAR(before[k] / g, way[k] / 0.25, 0.02) << i;
                ASSERT_NEAR(after[k] / g, way[k] / 0.25, 0.02) << i;
            }
        }
    }
}

// The box and the speed from the curves alone: a cubic through four of its points has these points of Bezier.
TEST(AnyTrack, IsBoundedByThePointsOfBezierOfItsCurves)
{
    for (uint64_t seed = 1; seed < seeds; ++seed) {
        const track::Track track = any_track(seed);
        glm::dvec3 low(1e9), high(-1e9);
        double fastest = 0, longest = 0;
        for (size_t i = 0; i + 1 < track.samples.size(); ++i) {
            const auto at = [&](double part) { return track::position_at(track, 100 + (double(i) + part) / 8); };
            const glm::dvec3 p0 = at(0), p1 = at(1.0 / 3), p2 = at(2.0 / 3), p3 = at(1);
            const glm::dvec3 b1 = (-5.0 * p0 + 18.0 * p1 - 9.0 * p2 + 2.0 * p3) / 6.0,
                             b2 = (2.0 * p0 - 9.0 * p1 + 18.0 * p2 - 5.0 * p3) / 6.0;
            for (const glm::dvec3 &p : {p0, b1, b2, p3})
                for (int k = 0; k < 3; ++k) {
                    ASSERT_GE(p[k], track.reach.low[k] - 1e-6) << i;
                    ASSERT_LE(p[k], track.reach.high[k] + 1e-6) << i;
                    low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
                }
            for (const glm::dvec3 &d : {b1 - p0, b2 - b1, p3 - b2}) {
                const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
                fastest = std::max(fastest, 24 * length), longest = std::max(longest, length);
            }
        }
        EXPECT_NEAR(track.top_speed, fastest, 1e-5 * fastest);
        for (int k = 0; k < 3; ++k) {
            EXPECT_GE(track.reach.low[k], low[k] - longest - 1e-6) << "no larger than a slope beyond the ends";
            EXPECT_LE(track.reach.high[k], high[k] + longest + 1e-6);
        }
    }
}

TEST(AnyTrack, ThatJumpsWhileItStandsHasNoTopSpeed)
{
    for (int k = 0; k < 3; ++k) {
        track::Track track = any_track(1);
        size_t i = 0;
        while (!(stands(track, i) && stands(track, i + 1))) ++i;
        if (k == 0) ++track.samples[i + 1].x;
        if (k == 1) track.samples[i + 1].height ^= 1;
        if (k == 2) ++track.samples[i + 1].z;
        EXPECT_EQ(track::top_speed_of(track), HUGE_VAL) << k;
    }
}

TEST(AnyTrack, IsPresentFromItsStartToItsEndAndRestsBeyond)
{
    const track::Track track = any_track(5);
    for (const double t : {100.0, 101.0, 102.5}) EXPECT_TRUE(track::is_present(track, t));
    for (const double t : {99.999, 102.501, -1e300, 1e300}) {
        EXPECT_FALSE(track::is_present(track, t));
        const track::Motion motion = track::motion_at(track, t);
        EXPECT_FALSE(motion.present);
        EXPECT_EQ(motion.speed, 0);
        EXPECT_EQ(motion.limb_speed, 0);
        EXPECT_EQ(motion.position, track::position_at(track, t < 101 ? 100 : 102.5));
    }
}

// A foot that stands is shown where its plant is, seen from the body; its weight comes and goes within 0.08 s.
TEST(AnyTrack, HasFeetWhereTheirPlantsAre)
{
    for (uint64_t seed = 1; seed < seeds; ++seed) {
        const track::Track track = any_track(seed);
        int planted = 0;
        for (int foot = 0; foot < 2; ++foot)
            for (double gone = -0.2; gone < 2.8; gone += 0.0093) {
                const track::Plant *on = nullptr;
                for (const track::Plant &plant : track.plants[foot])
                    if (double(plant.begin_s) <= gone && gone <= double(plant.end_s)) on = &plant;
                const track::State state = track::state_at(track, 100 + gone);
                const pose::FootTarget target = track::foot_at(track, state, foot, 100 + gone);
                ASSERT_EQ(target.planted, on != nullptr) << gone;
                if (!on) continue;
                ++planted;
                const double c = std::cos(state.heading_rad), s = std::sin(state.heading_rad);
                const double x = double(target.x) * track.scale, z = double(target.z) * track.scale;
                const glm::dvec3 body = state.position * track.metres_per_unit - track.origin_m;
                ASSERT_NEAR(body.x + x * c + z * s, double(on->x), 1e-5);
                ASSERT_NEAR(body.z - x * s + z * c, double(on->z), 1e-5);
                const double turn = shorter(double(on->heading_rad) - state.heading_rad);
                ASSERT_NEAR(target.turn_rad, std::clamp(turn, -0.7, 0.7), 1e-6);
                ASSERT_NEAR(double(target.y) * track.scale, std::isfinite(on->y) ? double(on->y) - body.y : 0, 1e-5);
                const double edge = std::min(gone - double(on->begin_s), double(on->end_s) - gone) / 0.08;
                const double part = std::clamp(edge, 0.0, 1.0);
                ASSERT_NEAR(target.ground, part * part * (3 - 2 * part), 1e-5) << gone;
            }
        EXPECT_GT(planted, 100);
    }
}

// In the air a foot goes from what its plant was off at the end to what the next one is off at the begin.
TEST(AnyTrack, TakesFeetFromOnePlantToTheNext)
{
    for (uint64_t seed = 1; seed < seeds; ++seed) {
        const track::Track track = any_track(seed);
        for (int foot = 0; foot < 2; ++foot)
            for (size_t i = 0; i + 1 < track.plants[foot].size(); ++i) {
                const track::Plant &a = track.plants[foot][i], &b = track.plants[foot][i + 1];
                const double length = double(b.begin_s) - double(a.end_s);
                for (const double part : {1e-6, 0.2, 0.5, 0.9, 1 - 1e-6}) {
                    const double t = 100 + double(a.end_s) + part * length;
                    const track::State state = track::state_at(track, t);
                    const track::Correction found = track::correction_at(track, state, foot, t);
                    const double gone = part * part * (3 - 2 * part);
                    ASSERT_NEAR(found.x, double(a.end_x) + (double(b.begin_x) - double(a.end_x)) * gone, 1e-5) << t;
                    ASSERT_NEAR(found.z, double(a.end_z) + (double(b.begin_z) - double(a.end_z)) * gone, 1e-5) << t;
                    const double from = shorter(double(a.heading_rad) - state.heading_rad),
                                 to = shorter(double(b.heading_rad) - state.heading_rad);
                    ASSERT_NEAR(found.turn_rad, from + (to - from) * gone, 1e-5) << t;
                    if (!std::isfinite(a.y)) {
                        ASSERT_EQ(found.y, 0);
                        continue;
                    }
                    // It is up by the first third of the way, or down within the last one.
                    const double own = state.position.y * track.metres_per_unit - track.origin_m.y;
                    const double low = double(std::min(a.y, b.y)) - own, high = double(std::max(a.y, b.y)) - own;
                    ASSERT_GE(found.y, low - 1e-6);
                    ASSERT_LE(found.y, high + 1e-6);
                    if (part >= 0.35 && part <= 0.65) {
                        ASSERT_NEAR(found.y, high, 1e-5);
                    }
                    if (part < 1e-5 || part > 1 - 1e-5) {
                        ASSERT_NEAR(found.y, double(part < 0.5 ? a.y : b.y) - own, 1e-5);
                    }
                }
            }
    }
}
