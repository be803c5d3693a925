// The plaza's plan: all individuals have room, walkers keep their lanes, and nothing depends on earlier frames.
#include <cmath>

#include <gtest/gtest.h>

#include "samples/scenes/plaza_layout.h"

namespace
{

using namespace scenes;

constexpr double walk_speed = 1.1;

struct Point {
    double x, z;
};

std::vector<Point> everybody(const PlazaLayout &plan, double time_s)
{
    std::vector<Point> points;
    for (const Standing &s : plan.standing)
        if (s.role != Standing::Role::speaker) points.push_back({s.x, s.z});
    for (const Walking &w : plan.walking) {
        const Step step = plan.lanes[w.lane].way.at(w.start + plan.lanes[w.lane].speed * time_s);
        points.push_back({step.x, step.z});
    }
    return points;
}

TEST(Plaza, EveryRequestedActorIsThere)
{
    for (uint32_t count : {1u, 2u, 7u, 30u, 149u, 150u, 400u, 1000u, 3000u}) {
        const PlazaLayout plan = lay_out_plaza(count, 1, walk_speed);
        EXPECT_EQ(plan.standing.size() + plan.walking.size(), count);
    }
}

TEST(Plaza, NoTwoActorsIntersectAtAnyTime)
{
    for (uint64_t seed : {1u, 2u, 3u})
        for (double time_s : {0.0, 1.5, 33.0, 1e5}) {
            const std::vector<Point> all = everybody(lay_out_plaza(400, seed, walk_speed), time_s);
            for (size_t i = 0; i < all.size(); ++i)
                for (size_t k = 0; k < i; ++k)
                    ASSERT_GT(std::hypot(all[i].x - all[k].x, all[i].z - all[k].z), 0.7) << seed << " at " << time_s;
        }
}

TEST(Plaza, NoActorStandsInTheFountainOrThePlatform)
{
    const PlazaLayout plan = lay_out_plaza(400, 1, walk_speed);
    for (const Point &p : everybody(plan, 12.0)) {
        EXPECT_GT(std::hypot(p.x - plan.fountain[0], p.z - plan.fountain[1]), plan.fountain_radius + 0.5);
        EXPECT_FALSE(std::abs(p.x - plan.rostra[0]) < plan.rostra_half[0] + 0.3 &&
                     std::abs(p.z - plan.rostra[1]) < plan.rostra_half[1] + 0.3);
    }
}

TEST(Plaza, ACircuitIsClosedAndWalkedForwardWithoutJumps)
{
    const Circuit way(10, 14, 3);
    const double step = 0.01;
    for (double at = -5; at < way.length() + 5; at += step) {
        const Step here = way.at(at), next = way.at(at + step);
        ASSERT_NEAR(here.dx * here.dx + here.dz * here.dz, 1, 1e-12);
        ASSERT_NEAR(next.x - here.x, here.dx * step, 1e-4) << at;
        ASSERT_NEAR(next.z - here.z, here.dz * step, 1e-4) << at;
    }
    EXPECT_NEAR(way.at(0).x, way.at(way.length()).x, 1e-9);
    EXPECT_NEAR(way.at(1).z, way.at(1 - 3 * way.length()).z, 1e-9);
}

}  // namespace
