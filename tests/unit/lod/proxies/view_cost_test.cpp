// The cost of a level's zones in views, against its definition.
#include "lib/lod/proxies/view_cost.h"

#include <gtest/gtest.h>

#include "lib/base/hash.h"

using namespace claque;

namespace
{

constexpr size_t view_count = 5, triangle_count = 7, zone_count = 4;

double random_fraction(uint64_t i) { return double(base::unit(base::mix(i))); }

lod::ZonesInViews random_views()
{
    lod::ZonesInViews made;
    const auto fractions = [](uint64_t seed, size_t count) {
        std::vector<double> all;
        double sum = 0;
        for (size_t i = 0; i < count; ++i) all.push_back(random_fraction(seed + i)), sum += all.back();
        for (double &one : all) one /= sum;
        return all;
    };
    for (size_t v = 0; v < view_count; ++v) {
        made.source.push_back(fractions(1000 * v, zone_count));
        made.triangles.push_back(fractions(1000 * v + 500, triangle_count));
    }
    return made;
}

// The mean over all views of the squared errors of all zones.
double by_definition(const lod::ZonesInViews &all, const std::vector<size_t> &shown)
{
    double sum = 0;
    for (size_t v = 0; v < view_count; ++v)
        for (size_t z = 0; z < zone_count; ++z) {
            double here = 0;
            for (size_t t = 0; t < triangle_count; ++t)
                if (shown[t] == z) here += all.triangles[v][t];
            sum += (here - all.source[v][z]) * (here - all.source[v][z]);
        }
    return sum / view_count;
}

}  // namespace

TEST(ViewCost, IsTheMeanSquaredErrorOfAllViewsLessThatOfAnEmptyLevel)
{
    const lod::ZonesInViews all = random_views();
    const double empty = by_definition(all, std::vector<size_t>(triangle_count, zone_count));
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        lod::ViewCost cost(all, triangle_count, zone_count, 3);
        std::vector<size_t> shown(triangle_count, zone_count);
        std::vector<double> added;
        double sum = 0;
        for (size_t t = 0; t < triangle_count; ++t) {
            const size_t zone = base::mix(100 * seed + t) % zone_count;
            cost.added(t, shown, added);
            sum += added[zone];
            cost.set(t, lod::ViewCost::no_zone, zone), shown[t] = zone;
        }
        EXPECT_NEAR(cost.cost(), 3 * (by_definition(all, shown) - empty), 1e-12);
        EXPECT_NEAR(sum, cost.cost(), 1e-12) << "the parts of a partial assignment";
    }
}

TEST(ViewCost, GainsWhatAChangeTakesAway)
{
    const lod::ZonesInViews all = random_views();
    lod::ViewCost cost(all, triangle_count, zone_count, 1);
    std::vector<size_t> shown(triangle_count, 0);
    for (size_t t = 0; t < triangle_count; ++t) cost.set(t, lod::ViewCost::no_zone, 0);
    for (uint64_t i = 0; i < 100; ++i) {
        const size_t t = base::mix(2 * i) % triangle_count, zone = base::mix(2 * i + 1) % zone_count;
        if (zone == shown[t]) continue;
        const double before = by_definition(all, shown), gain = cost.gain(t, shown[t], zone);
        cost.set(t, shown[t], zone), shown[t] = zone;
        EXPECT_NEAR(gain, before - by_definition(all, shown), 1e-12);
    }
}

TEST(ViewCost, IsNothingWithoutViews)
{
    lod::ViewCost cost({}, triangle_count, zone_count, 1);
    cost.set(3, lod::ViewCost::no_zone, 1);
    EXPECT_EQ(cost.cost(), 0);
    EXPECT_EQ(cost.gain(3, 1, 2), 0);
}

// As from behind a surface with one side: zones of the level there are neither right nor wrong.
TEST(ViewCost, IsNothingWhereTheSourceShowsNothing)
{
    lod::ZonesInViews all = random_views();
    for (std::vector<double> &view : all.source) view.assign(zone_count, 0);
    lod::ViewCost cost(all, triangle_count, zone_count, 1);
    for (size_t t = 0; t < triangle_count; ++t) cost.set(t, lod::ViewCost::no_zone, t % zone_count);
    EXPECT_EQ(cost.cost(), 0);
    EXPECT_EQ(cost.gain(3, 3, 2), 0);
}
