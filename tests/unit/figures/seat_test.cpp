// Seated clips on the seat that they are made for: its top at 0.43 m, its front edge 0.17 m behind the origin.
#include <algorithm>

#include <gtest/gtest.h>

#include "lib/figures/clips/clips.h"
#include "puppet.h"

using claque::figures::seat_edge_m;
using claque::figures::seat_height_m;
using puppet::citizen;
using puppet::clip;
using puppet::frame_s;
using puppet::frames;
using puppet::node;
using puppet::pose;
using puppet::Posed;
using puppet::vec3;

namespace
{

float furthest(const Posed &a, const Posed &b)
{
    float most = 0;
    for (size_t v = 0; v < a.vertices.size(); ++v) most = std::max(most, glm::distance(a.vertices[v], b.vertices[v]));
    return most;
}

Posed at_end(const char *name) { return pose(clip(name), float(frames(clip(name))) * frame_s); }

// Depth of a point inside the stone, by the shorter way out; negative outside.
float depth_in_seat(vec3 p) { return std::min(seat_height_m - p.y, seat_edge_m - p.z); }

// The lowest vertex between belt and knee (at rest) that is over the seat now.
float lowest_over_seat(const Posed &p, const puppet::Model &figure = citizen())
{
    const auto &rest = figure.parts[0].positions;
    float y = 1e9f;
    for (size_t v = 0; v < rest.size(); ++v)
        if (rest[v].y > 0.60f && rest[v].y < 0.95f && std::fabs(rest[v].x) < 0.30f && p.vertices[v].z < seat_edge_m)
            y = std::min(y, p.vertices[v].y);
    return y;
}

class Seated : public testing::TestWithParam<const char *>
{
protected:
    // Times of keys and times between them.
    template <typename Check>
    void always(Check check) const
    {
        const uint32_t c = clip(GetParam());
        for (int k = 0; k <= 2 * frames(c); ++k) {
            SCOPED_TRACE("half frame " + std::to_string(k));
            check(pose(c, float(k) * frame_s / 2));
            if (HasFailure()) return;
        }
    }
};

class Planted : public Seated
{
};

}  // namespace

TEST_P(Seated, BeginsAndEndsInTheOneNeutralPose)
{
    const Posed neutral = pose(clip("sit"), 0);
    EXPECT_LT(furthest(pose(clip(GetParam()), 0), neutral), 2e-4f);
    EXPECT_LT(furthest(at_end(GetParam()), neutral), 2e-4f);
}

TEST_P(Seated, Moves)
{
    const uint32_t c = clip(GetParam());
    const Posed neutral = pose(c, 0);
    float most = 0;
    for (int k = 0; k < frames(c); k += 3) most = std::max(most, furthest(pose(c, float(k) * frame_s), neutral));
    EXPECT_GT(most, 0.02f);
}

TEST_P(Seated, RestsOnTheSeat)
{
    always([](const Posed &p) {
        EXPECT_GT(lowest_over_seat(p), seat_height_m - 0.025f);
        EXPECT_LT(lowest_over_seat(p), seat_height_m + 0.030f);
        EXPECT_NEAR(p.joints[node("pelvis")].z, -0.40f, 0.06f);
    });
}

TEST_P(Seated, KeepsToItsOwnSeat)
{
    always([](const Posed &p) {
        for (size_t v = 0; v < p.vertices.size(); ++v) EXPECT_LE(std::fabs(p.vertices[v].x), 0.31f) << "vertex " << v;
        for (const vec3 q : p.vertices)
            EXPECT_TRUE(q.z > -0.58f || q.y > 0.60f) << "where the toes of sitters behind are";
    });
}

TEST_P(Seated, KeepsTheKneesTogetherAsFarAsAGownNeeds)
{
    always([](const Posed &p) {
        EXPECT_LT(glm::distance(p.joints[node("shin_l")], p.joints[node("shin_r")]), 0.30f);
        for (const char *leg : {"thigh_l", "thigh_r"}) {
            const vec3 d = p.joints[node(leg) + 2] - p.joints[node(leg)];  // to the knee of the same side
            EXPECT_NEAR(d.y, 0, 0.06f) << "thighs lie level";
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Citizen, Seated, testing::ValuesIn(puppet::seated_clips),
                         [](const auto &clip_info) { return std::string(clip_info.param); });

TEST_P(Planted, NeverPassesThroughTheStone)
{
    always([](const Posed &p) {
        for (size_t v = 0; v < p.vertices.size(); ++v)
            EXPECT_LT(depth_in_seat(p.vertices[v]), 0.010f)
                << "vertex " << v << " at " << p.vertices[v].y << ", " << p.vertices[v].z;
    });
}

TEST_P(Planted, KeepsBothFeetFlatWhereTheyStand)
{
    const Posed standing = pose(clip("stand"), 0);
    always([&standing](const Posed &p) {
        for (size_t v = 0; v < p.vertices.size(); ++v)
            EXPECT_TRUE(standing.vertices[v].y > 0.02f || glm::distance(p.vertices[v], standing.vertices[v]) < 0.015f);
    });
}

INSTANTIATE_TEST_SUITE_P(Citizen, Planted, testing::ValuesIn(puppet::seated_clips),
                         [](const auto &clip_info) { return std::string(clip_info.param); });

INSTANTIATE_TEST_SUITE_P(Ways, Planted, testing::ValuesIn(puppet::ways),
                         [](const auto &clip_info) { return std::string(clip_info.param); });

TEST(Rising, BeginsSeatedAndEndsWhereStandBegins)
{
    EXPECT_LT(furthest(pose(clip("rise"), 0), pose(clip("sit"), 0)), 1e-3f);
    EXPECT_LT(furthest(at_end("rise"), pose(clip("stand"), 0)), 1e-3f);
}

TEST(Rising, SittingDownGoesTheOtherWay)
{
    EXPECT_LT(furthest(pose(clip("sit_down"), 0), pose(clip("stand"), 0)), 1e-3f);
    EXPECT_LT(furthest(at_end("sit_down"), pose(clip("sit"), 0)), 1e-3f);
}

TEST(Rising, BringsTheWeightOverTheFeetBeforeTheHipsLeaveTheSeat)
{
    for (const char *name : puppet::ways) {
        const uint32_t c = clip(name);
        const float seated = pose(clip("sit"), 0).joints[node("pelvis")].y;
        for (int k = 0; k <= frames(c); ++k) {
            const Posed p = pose(c, float(k) * frame_s);
            const float lifted = p.joints[node("pelvis")].y - seated;
            if (lifted < 0.05f || lifted > 0.20f) continue;
            EXPECT_GT(p.joints[node("neck")].z, -0.08f)
                << name << " at frame " << k << ": a body cannot rise like that";
        }
    }
}

TEST(Standing, MayBeFollowedByAWaveALaughOrAnOvation)
{
    for (const char *name : {"stand_wave", "stand_laugh", "stand_applaud", "stand_cheer"}) {
        EXPECT_LT(furthest(pose(clip(name), 0), pose(clip("stand"), 0)), 1e-4f) << name;
        EXPECT_LT(furthest(at_end(name), pose(clip("stand"), 0)), 1e-4f) << name;
    }
}

// Rows stand as close as they sit; only raised arms may overlap a neighbour's a little.
TEST(Standing, KeepsTheArmsWithinItsOwnSeat)
{
    for (const char *name :
         {"rise", "sit_down", "stand", "stand_wave", "stand_laugh", "stand_applaud", "stand_cheer"}) {
        const uint32_t c = clip(name);
        for (int k = 0; k <= frames(c); ++k)
            for (const vec3 q : pose(c, float(k) * frame_s).vertices)
                ASSERT_LT(std::fabs(q.x), 0.37f) << name << " at frame " << k;
    }
}

// Togas and stolas are wider than a tunic, but all seats are 0.65 m wide.
TEST(SeatedPeople, FitOnTheirOwnSeats)
{
    for (const auto &builtin : claque::figures::people()) {
        const auto figure = builtin.make();
        for (const char *name : puppet::seated_clips) {
            const uint32_t c = figure.rig.find_clip(name);
            for (int k = 0; k < puppet::frames(figure, c); k += 3) {
                SCOPED_TRACE(std::string(builtin.name) + ' ' + name + " at frame " + std::to_string(k));
                const Posed p = pose(figure, c, float(k) * frame_s);
                ASSERT_NEAR(lowest_over_seat(p, figure), seat_height_m, 0.025f);
                for (const vec3 q : p.vertices) {
                    ASSERT_LE(std::fabs(q.x), 0.325f);
                    ASSERT_TRUE(q.z > -0.59f || q.y > 0.60f) << "where the toes of sitters behind are";
                }
            }
        }
    }
}
