// The ground that people can walk on is what was given, less what is too steep, low, narrow or high to step on; and
// nothing that a host gives can make it take more than it may.
#include <claque/trajectories.h>

#include <limits>

#include "tests/unit/walk/floors.h"

using floors::Floor;

namespace
{

clq_navigation_info info_of(const clq_navigation_def &def)
{
    clq_navigation *made = nullptr;
    clq_navigation_info info = clq_navigation_info_init();
    EXPECT_EQ(clq_navigation_create(&def, &made), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_navigation_get_info(made, &info), CLQ_OK);
    clq_navigation_destroy(made);
    return info;
}

double area_of(const Floor &floor) { return info_of(floor.def()).area_m2; }

void refused(const clq_navigation_def &def, clq_status status, const char *words)
{
    clq_navigation *made = nullptr;
    EXPECT_EQ(clq_navigation_create(&def, &made), status) << words;
    EXPECT_NE(std::string(clq_last_error()).find(words), std::string::npos) << clq_last_error();
    EXPECT_EQ(made, nullptr);
    clq_navigation_destroy(made);
}

// From one end of the x axis to the other.
bool crosses(const Floor &floor)
{
    clq_navigation *made = floor.make().release();
    const double from[3] = {0.5, 0, 2}, to[3] = {9.5, 0, 2};
    clq_way way = clq_way_init();
    EXPECT_EQ(clq_navigation_find_way(made, from, to, 0, nullptr, &way), CLQ_OK) << clq_last_error();
    clq_navigation_destroy(made);
    return way.complete;
}

}  // namespace

TEST(Ground, IsWhatWasGivenLessTheRadiusAtItsEdges)
{
    Floor floor;
    floor.add(0, 0, 20, 10);
    // Right to a cell of 0.1 m at each edge.
    EXPECT_NEAR(area_of(floor), 19.6 * 9.6, 0.1 * 60);
    floor.wall(8, 4, 10, 6);
    EXPECT_NEAR(area_of(floor), 19.6 * 9.6 - 2.4 * 2.4, 0.1 * 70);
}

TEST(Ground, LeavesOutWhatIsTooSteepLowOrHigh)
{
    for (const auto &[rise, walks] : {std::pair<double, bool>{0.9, true}, {4, false}}) {  // 24 and 63 degrees
        Floor slope;
        slope.add(0, 0, 4, 4), slope.add(4, 0, 6, 4, 0, rise), slope.add(6, 0, 10, 4, rise, rise);
        slope.add(9, 0, 10, 4, rise, rise);
        clq_navigation *made = slope.make().release();
        const double from[3] = {0.5, 0, 2}, to[3] = {9.5, rise, 2};
        clq_way way = clq_way_init();
        ASSERT_EQ(clq_navigation_find_way(made, from, to, 0, nullptr, &way), CLQ_OK);
        EXPECT_EQ(way.complete, walks) << rise;
        clq_navigation_destroy(made);
    }
    for (const auto &[step, walks] : {std::pair<double, bool>{0.2, true}, {0.5, false}}) {
        Floor stair;
        stair.add(0, 0, 5, 4), stair.add(5, 0, 10, 4, step, step);
        EXPECT_EQ(crosses(stair), walks) << step;
    }
    // A sill above the floor, too steep to stand on: one steps over it unless it is higher than a step.
    for (const auto &[sill, walks] : {std::pair<double, bool>{0.2, true}, {0.6, false}}) {
        Floor with_sill;
        with_sill.add(0, 0, 10, 4), with_sill.add(5, 0, 5.04, 4, sill - 0.1, sill);
        EXPECT_EQ(crosses(with_sill), walks) << sill;
    }
    for (const auto &[ceiling, walks] : {std::pair<double, bool>{2.2, true}, {1.5, false}}) {
        Floor tunnel;
        tunnel.add(0, 0, 10, 4), tunnel.add(4, 0, 6, 4, ceiling, ceiling);
        EXPECT_EQ(crosses(tunnel), walks) << ceiling;
    }
    for (const auto &[width, walks] : {std::pair<double, bool>{0.8, true}, {0.3, false}}) {
        Floor gap;
        gap.add(0, 0, 10, 4);
        gap.wall(4, 0, 5, 2 - width / 2), gap.wall(4, 2 + width / 2, 5, 4);
        EXPECT_EQ(crosses(gap), walks) << width;
    }
}

TEST(Ground, IsTheSameInOtherUnitsAndFarAway)
{
    Floor floor = floors::two_rooms(false), feet = floor, far = floor;
    for (double &x : feet.vertices) x /= 0.3048;
    for (auto &outline : feet.outlines)
        for (double &x : outline) x /= 0.3048;
    for (size_t i = 0; i < feet.holes.size(); ++i) {
        feet.holes[i].points = feet.outlines[i].data();
        feet.holes[i].min_y /= 0.3048, feet.holes[i].max_y /= 0.3048;
    }
    clq_navigation_def in_feet = feet.def();
    in_feet.metres_per_unit = 0.3048f;
    EXPECT_NEAR(info_of(in_feet).area_m2, area_of(floor), 0.5);
    for (size_t i = 0; i < far.vertices.size(); i += 3) far.vertices[i] += 3e6, far.vertices[i + 2] -= 7e6;
    far.holes.clear(), floor.holes.clear();
    EXPECT_NEAR(area_of(far), area_of(floor), 0.5);
}

TEST(Ground, ComesFromAWalkableAreaOfAFile)
{
    const char hall[] = "POLYGON ((0 0, 12 0, 12 8, 0 8, 0 0), (5 3, 5 5, 7 5, 7 3, 5 3))";
    clq_context *context = nullptr;
    clq_area *area = nullptr;
    ASSERT_EQ(clq_context_create(nullptr, &context), CLQ_OK);
    ASSERT_EQ(clq_area_load_memory(context, hall, sizeof hall - 1, "hall.wkt", &area), CLQ_OK) << clq_last_error();
    clq_area_info found = clq_area_info_init();
    ASSERT_EQ(clq_area_get_info(area, &found), CLQ_OK);
    Floor floor;
    for (uint32_t i = 0; i < found.point_count; ++i)
        for (const double x : {found.points_m[3 * i], found.points_m[3 * i + 2], -found.points_m[3 * i + 1]})
            floor.vertices.push_back(x);
    floor.triangles.assign(found.triangles, found.triangles + 3 * size_t(found.triangle_count));
    EXPECT_NEAR(area_of(floor), 11.6 * 7.6 - 2.4 * 2.4, 0.1 * 50);
    clq_area_destroy(area);
    EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
}

TEST(Ground, OfManyTilesIsOne)
{
    Floor floor;
    floor.add(0, 0, 90, 3);
    clq_navigation *made = floor.make().release();
    clq_navigation_info info = clq_navigation_info_init();
    ASSERT_EQ(clq_navigation_get_info(made, &info), CLQ_OK);
    EXPECT_GE(info.tile_count, 7u);
    const double from[3] = {0.5, 0, 1.5}, to[3] = {89.5, 0, 1.5};
    clq_way way = clq_way_init();
    ASSERT_EQ(clq_navigation_find_way(made, from, to, 0, nullptr, &way), CLQ_OK);
    EXPECT_TRUE(way.complete);
    EXPECT_NEAR(way.length, 89, 0.3);
    clq_navigation_destroy(made);
}

TEST(Ground, ThatMeansNothingIsRefusedWithItsNumber)
{
    Floor floor;
    floor.add(0, 0, 10, 4);
    clq_navigation_def def = floor.def();
    def.triangle_count = 0;
    refused(def, CLQ_ARGUMENT, "no triangles");
    def = floor.def(), def.vertices = nullptr;
    refused(def, CLQ_ARGUMENT, "vertices or triangles is NULL");
    def = floor.def(), def.struct_bytes = 3;
    refused(def, CLQ_STRUCT_SIZE, "struct_bytes is 3");
    for (const float bad : {0.0f, -1.0f, NAN, INFINITY, 1e9f}) {
        def = floor.def(), def.radius_m = bad;
        refused(def, CLQ_ARGUMENT, "radius_m is");
        def = floor.def(), def.metres_per_unit = bad;
        refused(def, CLQ_ARGUMENT, "metres_per_unit is");
    }
    def = floor.def(), def.cell_m = 0.001f;
    refused(def, CLQ_ARGUMENT, "cell_m is 0.001: 0.02 to 2 is wanted");
    for (const double bad : {double(NAN), double(INFINITY)}) {
        Floor broken = floor;
        broken.vertices[7] = bad;
        refused(broken.def(), CLQ_ARGUMENT, "vertex 2 to walk on is not finite");
    }
    Floor broken = floor;
    broken.triangles[4] = 4;
    refused(broken.def(), CLQ_ARGUMENT, "triangle 1 to walk on names vertex 4 of 4");
    broken = floor;
    std::swap(broken.triangles[0], broken.triangles[1]), std::swap(broken.triangles[3], broken.triangles[4]);
    refused(broken.def(), CLQ_ARGUMENT, "of 2 triangles none can be walked on");
}

TEST(Ground, PrismsThatMeanNothingAreRefusedWithTheirNumber)
{
    Floor floor;
    floor.add(0, 0, 10, 4);
    floor.wall(1, 1, 2, 2), floor.wall(4, 1, 5, 2);
    Floor bad = floor;
    bad.holes[1].point_count = 2;
    refused(bad.def(), CLQ_ARGUMENT, "hole 1 has 2 points");
    const double dart[] = {0, 0, 4, 0, 1, 1, 0, 4}, line[] = {0, 0, 1, 1, 2, 2}, lost[] = {0, 0, NAN, 1, 2, 0};
    bad = floor, bad.holes[1].points = dart;
    refused(bad.def(), CLQ_ARGUMENT, "hole 1 is not convex");
    bad = floor, bad.holes[1].points = line, bad.holes[1].point_count = 3;
    refused(bad.def(), CLQ_ARGUMENT, "hole 1 is flat");
    bad = floor, bad.holes[1].points = lost, bad.holes[1].point_count = 3;
    refused(bad.def(), CLQ_ARGUMENT, "point 1 of hole 1");
    bad = floor, bad.holes[0].max_y = bad.holes[0].min_y;
    refused(bad.def(), CLQ_ARGUMENT, "hole 0 is flat");
    bad = floor, bad.door(20, 20, 21, 21);
    refused(bad.def(), CLQ_ARGUMENT, "door 0 lies on no ground");
    bad = floor;
    for (int i = 0; i < 63; ++i) bad.door(0.1 * i, 0, 0.1 * i + 0.1, 1);
    refused(bad.def(), CLQ_ARGUMENT, "63 doors: 62 are possible");
}

TEST(Ground, IsRefusedBeforeItTakesMoreThanItMay)
{
    Floor wide;
    wide.add(-20000, -20000, 20000, 20000);
    refused(wide.def(), CLQ_LIMIT, "16384 tiles");
    Floor far;
    far.add(0, 0, 10, 4), far.add(1e7, 0, 1e7 + 10, 4);
    refused(far.def(), CLQ_LIMIT, "50000 m are possible");
    Floor tall;
    tall.add(0, 0, 10, 4), tall.add(0, 0, 10, 4, 900, 900);
    refused(tall.def(), CLQ_LIMIT, "m high");
    Floor layers;  // each covers all of a tile
    for (int i = 0; i < 3000; ++i) layers.add(0, 0, 12, 12, 0.01 * i, 0.01 * i);
    refused(layers.def(), CLQ_LIMIT, "cover more than");
    Floor large;
    large.add(0, 0, 400, 400);
    clq_navigation_def def = large.def();
    def.max_cells = 1000000;
    refused(def, CLQ_LIMIT, "cover more than 1000000 cells of 0.1 m");
    Floor huge;
    huge.add(-1e300, 0, 1e300, 4);
    refused(huge.def(), CLQ_LIMIT, "m are possible");
}

TEST(Ground, OfAnyTrianglesIsMadeOrRefused)
{
    for (uint64_t seed = 1; seed < 60; ++seed) {
        uint64_t bits = seed;
        const auto number = [&bits] {
            return double((bits = bits * 6364136223846793005u + 1442695040888963407u) >> 33) / (1u << 31);
        };
        Floor floor;
        const uint32_t count = 3 + uint32_t(40 * number());
        for (uint32_t i = 0; i < 3 * count; ++i) floor.vertices.push_back((i % 3 == 1 ? 3 : 25) * number());
        for (uint32_t i = 0; i < 60; ++i) floor.triangles.push_back(uint32_t(count * number()));
        const clq_navigation_def def = floor.def();
        clq_navigation *made = nullptr;
        const clq_status status = clq_navigation_create(&def, &made);
        ASSERT_TRUE(status == CLQ_OK || status == CLQ_ARGUMENT) << clq_last_error();
        clq_navigation_destroy(made);
    }
}
