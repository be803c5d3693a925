// The town on a market day: people can walk from its streets to every stall, and through nothing that stands there.
#include <claque/navigation.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "samples/scenes/town/walkable.h"

namespace
{

using namespace scenes;
using namespace scenes::town;

struct Market {
    Market() : town(1, Trade::market_day), walkable(walkable_square(town, 30))
    {
        std::vector<clq_prism> holes;
        for (const Walkable::Prism &one : walkable.obstacles)
            holes.push_back({static_cast<uint32_t>(one.outline.size() / 2), one.outline.data(), one.low_m, one.high_m});
        clq_navigation_def def = clq_navigation_def_init();
        def.vertex_count = static_cast<uint32_t>(walkable.vertices.size() / 3);
        def.vertices = walkable.vertices.data();
        def.triangle_count = static_cast<uint32_t>(walkable.triangles.size() / 3);
        def.triangles = walkable.triangles.data();
        def.hole_count = static_cast<uint32_t>(holes.size()), def.holes = holes.data();
        def.radius_m = 0.25f, def.cell_m = 0.125f;
        EXPECT_EQ(clq_navigation_create(&def, &navigation), CLQ_OK) << clq_last_error();
        stalls = stall_sites(town.plan(), Trade::market_day);
    }
    ~Market() { clq_navigation_destroy(navigation); }

    std::array<double, 3> on_ground(Point p) const { return {p.x, town.height(p.x, p.z), p.z}; }
    bool has_ground(Point p, double reach) const
    {
        const std::array<double, 3> from = on_ground(p);
        double place[3];
        bool found = false;
        EXPECT_EQ(clq_navigation_find_nearest(navigation, from.data(), reach, place, &found), CLQ_OK);
        return found && std::hypot(place[0] - p.x, place[2] - p.z) < reach;
    }
    std::vector<Point> way(Point from, Point to) const
    {
        clq_way found = clq_way_init();
        std::vector<double> points(3 * 256);
        EXPECT_EQ(clq_navigation_find_way(navigation, on_ground(from).data(), on_ground(to).data(), 256, points.data(),
                                          &found),
                  CLQ_OK);
        EXPECT_TRUE(found.complete);
        std::vector<Point> out;
        for (uint32_t i = 0; i < found.point_count; ++i) out.push_back({points[3 * i], points[3 * i + 2]});
        return out;
    }

    Town town;
    Walkable walkable;
    std::vector<Site> stalls;
    clq_navigation *navigation = nullptr;
};

const Market &the_market()
{
    static const Market market;
    return market;
}

bool is_within(const std::vector<double> &outline, Point p)
{
    bool left = false, right = false;
    const size_t count = outline.size() / 2;
    for (size_t i = 0; i < count; ++i) {
        const size_t next = (i + 1) % count;
        const double ax = outline[2 * i], az = outline[2 * i + 1];
        const double side = (outline[2 * next] - ax) * (p.z - az) - (outline[2 * next + 1] - az) * (p.x - ax);
        (side < 0 ? left : right) = true;
    }
    return !(left && right);
}

std::vector<Point> street_corners()
{
    const Plan &plan = the_market().town.plan();
    std::vector<Point> corners;
    for (const size_t u : {1u, 2u})
        for (const size_t v : {1u, 2u}) corners.push_back(plan.at(plan.streets_u()[u], plan.streets_v()[v]));
    return corners;
}

}  // namespace

TEST(TownMarket, HasMoreStallsThanAnOrdinaryDay)
{
    const Plan &plan = the_market().town.plan();
    EXPECT_EQ(stall_sites(plan, Trade::ordinary).size(), 8u);
    EXPECT_GE(the_market().stalls.size(), 24u);
    for (const Site &a : the_market().stalls)
        for (const Site &b : the_market().stalls) {
            if (&a == &b) continue;
            EXPECT_GT(std::hypot(a.ground(0, 0).x - b.ground(0, 0).x, a.ground(0, 0).z - b.ground(0, 0).z), 3.0);
        }
}

TEST(TownMarket, LeadsFromEveryStreetCornerToBothSidesOfEveryStall)
{
    for (const Point &corner : street_corners())
        for (const Site &stall : the_market().stalls)
            for (const double out : {1.35, -0.45}) EXPECT_GE(the_market().way(corner, stall.ground(0, out)).size(), 2u);
}

TEST(TownMarket, LeadsThroughNothingThatStandsThere)
{
    size_t points = 0;
    for (const Point &corner : street_corners())
        for (const Site &stall : the_market().stalls) {
            const std::vector<Point> way = the_market().way(corner, stall.ground(0, 1.35));
            for (size_t i = 1; i < way.size(); ++i)
                for (double share = 0; share < 1; share += 0.02) {
                    const Point p = {way[i - 1].x + share * (way[i].x - way[i - 1].x),
                                     way[i - 1].z + share * (way[i].z - way[i - 1].z)};
                    ++points;
                    for (const Walkable::Prism &one : the_market().walkable.obstacles)
                        ASSERT_FALSE(is_within(one.outline, p)) << p.x << ", " << p.z;
                }
        }
    EXPECT_GT(points, 10000u);
}

TEST(TownMarket, HasNoGroundWhereThingsStand)
{
    const Market &market = the_market();
    const SquarePlan plan = square_plan(market.town.plan());
    EXPECT_FALSE(market.has_ground(market.town.plan().at(plan.fountain_u, plan.fountain_v), 3.5));
    EXPECT_FALSE(market.has_ground(market.town.plan().at(plan.church_u, plan.church_v), 4));
    EXPECT_FALSE(market.has_ground(market.town.plan().at(plan.hall_u, plan.hall_v), 4));
    for (const Site &stall : market.stalls) {
        EXPECT_FALSE(market.has_ground(stall.ground(0, 0.5), 0.3));
        EXPECT_TRUE(market.has_ground(stall.ground(0, 1.35), 0.1));
        EXPECT_TRUE(market.has_ground(stall.ground(0, -0.45), 0.1));
    }
}

TEST(TownMarket, IsTheGroundThatIsDrawn)
{
    const Market &market = the_market();
    for (const Site &stall : market.stalls) {
        const std::array<double, 3> from = market.on_ground(stall.ground(0, 2));
        double place[3];
        bool found = false;
        ASSERT_EQ(clq_navigation_find_nearest(market.navigation, from.data(), 1, place, &found), CLQ_OK);
        ASSERT_TRUE(found);
        EXPECT_NEAR(place[1], market.town.height(place[0], place[2]), 0.15);
    }
}
