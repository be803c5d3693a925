// Areas of files: their size against what others printed, and their triangles against their rings.
#include <algorithm>
#include <array>

#include "../trajectories/writers.h"
#include "fixture.h"

namespace claque::testing
{
namespace
{

struct AreaFile {
    const char *name;
    double area_m2, half_step;
    uint32_t polygons, holes;
    double width_m, depth_m;
};

// As the README of the tracks prints it.
const AreaFile area_files[] = {
    {"jupedsim/bottleneck.wkt", 210.0, 0.05, 1, 0, 30, 10},
    {"jupedsim/t_shaped_room.wkt", 104.0, 0.05, 1, 0, 20, 10},
    {"jupedsim/corner_with_shortcut.wkt", 337.5, 0.05, 1, 1, 30, 30},
    {"jupedsim/triangular_obstacles.wkt", 38.0, 0.05, 1, 0, 10, 4},
    {"jupedsim/office_rooms.wkt", 69.6, 0.05, 1, 0, 9, 8},
    {"jupedsim/arena.wkt", 262.5, 0.05, 1, 18, 20.6, 21.6},
    {"jupedsim/BUW.wkt", 1377.6, 0.05, 1, 40, 50.3, 32.2},
    {"jupedsim/aknz_evac.wkt", 13189, 0.5, 1, 5, 478, 288},
    {"menge/simple.nav", 36, 0.5, 8, 0, 8, 9},
    {"menge/maze.nav", 1220.6, 0.05, 303, 0, 56.4, 57.6},
    {"menge/tradeshow.nav", 1972.5, 0.05, 338, 0, 53.6, 67.0},
    {"pedpy/jupedsim_v2.sqlite", 0, 0, 1, 2, 0, 0},
    {"pedpy/trajectories.sqlite", 104.0, 0.05, 1, 0, 20, 10},
    // 3 x 8 and 5 x 3; 6.25 x 14.75 without both sides of the passage, 1.06 deep.
    {"pedpy/ref-corner/geo.xml", 3 * 8 + 5 * 3, 1e-9, 1, 0, 8, 8},
    {"pedpy/ref-bottleneck/geo.xml", 6.25 * 14.75 - 1.06 * (1.65 + 1.6), 1e-9, 1, 0, 6.25, 14.75},
    // 7 x 9 without two obstacles.
    {"pedpy/vadere_bottleneck.scenario", 0, 0, 1, 2, 7, 9},
};

void PrintTo(const AreaFile &file, std::ostream *out) { *out << file.name; }

class AreaFiles : public ::testing::TestWithParam<AreaFile>
{
};

TEST_P(AreaFiles, HaveTheSizeOfTheTableAndAreFilled)
{
    CLAQUE_NEEDS_TRACKS();
    const AreaFile &file = GetParam();
    CLAQUE_NEEDS_LIBRARY_OF(file.name);
    const Bytes bytes = asset::read_file(tracks_folder() + file.name, 1u << 30);
    const asset::Area area = asset::read_area(bytes.data(), bytes.size());
    EXPECT_EQ(area.polygons, file.polygons);
    uint32_t holes = 0;
    for (const clq_area_ring &ring : area.rings) holes += ring.hole;
    EXPECT_EQ(holes, file.holes);
    if (file.area_m2 > 0) {
        EXPECT_NEAR(area.area_m2, file.area_m2, file.half_step);
    }
    expect_filled(area);
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < area.points.size(); ++i)
        if (i % 3 < 2)
            low[i % 3] = std::min(low[i % 3], area.points[i]), high[i % 3] = std::max(high[i % 3], area.points[i]);
    if (file.width_m == 0) return;
    EXPECT_NEAR(high[0] - low[0], file.width_m, file.width_m > 100 ? 0.5 : 0.05);
    EXPECT_NEAR(high[1] - low[1], file.depth_m, file.depth_m > 100 ? 0.5 : 0.05);
}

INSTANTIATE_TEST_SUITE_P(Tracks, AreaFiles, ::testing::ValuesIn(area_files), [](const auto &chosen) {
    std::string name = chosen.param.name;
    for (char &c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
});

TEST(Areas, ObstaclesOfAMeshAreItsWallsAtTheHeightOfTheirNode)
{
    CLAQUE_NEEDS_TRACKS();
    const Bytes bytes = asset::read_file(tracks_folder() + "menge/simple.nav", 1u << 20);
    const asset::Area area = asset::read_area(bytes.data(), bytes.size());
    ASSERT_EQ(area.walls.size(), 2 * 13u);
    // Obstacle 6 joins (1, 0) and (1, -3) of the flat node.
    const double *from = &area.points[3 * size_t(area.walls[12])], *to = &area.points[3 * size_t(area.walls[13])];
    const std::array<double, 3> begin{1, 0, 0}, end{1, -3, 0};
    EXPECT_TRUE(std::equal(begin.begin(), begin.end(), from));
    EXPECT_TRUE(std::equal(end.begin(), end.end(), to));
    EXPECT_EQ(area.points[2], 1) << "the first node lies 1 m up";
}

TEST(Areas, OfWellKnownTextAreRead)
{
    const char *square = "((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))";
    const asset::Area one = read_area_text(std::string("POLYGON") + square);
    EXPECT_EQ(one.area_m2, 15);
    ASSERT_EQ(one.rings.size(), 2u);
    EXPECT_EQ(one.rings[0].point_count, 4u) << "the first point is not repeated";
    EXPECT_TRUE(one.rings[1].hole);
    EXPECT_EQ(one.walls.size(), 2 * 8u);
    expect_filled(one);
    const std::string more = std::string(square) + ", ((10 0, 11 0, 10 1))";
    EXPECT_EQ(read_area_text("MULTIPOLYGON (" + more + ")\n").area_m2, 15.5);
    const asset::Area nested = read_area_text("\xef\xbb\xbf geometrycollection (Polygon " + std::string(square) +
                                              ", POLYGON EMPTY, GEOMETRYCOLLECTION EMPTY, "
                                              "GEOMETRYCOLLECTION(MULTIPOLYGON EMPTY,POLYGON Z ((1e1 0 7,\n11 0 7 , "
                                              "10 1 7))))");
    EXPECT_EQ(nested.polygons, 2u);
    EXPECT_EQ(nested.area_m2, 15.5);
    EXPECT_EQ(nested.rings[2].polygon, 1u);
    EXPECT_EQ(read_area_text("POLYGON EMPTY").area_m2, 0);
    EXPECT_TRUE(read_area_text("GEOMETRYCOLLECTION EMPTY").points.empty());
}

TEST(Areas, RunCounterClockwiseAndTheirHolesClockwise)
{
    for (const char *text : {"POLYGON ((0 0, 4 0, 4 4, 0 4), (1 1, 1 2, 2 2, 2 1))",
                             "POLYGON ((0 0, 0 4, 4 4, 4 0), (1 1, 2 1, 2 2, 1 2))"}) {
        const asset::Area area = read_area_text(text);
        for (const clq_area_ring &ring : area.rings) {
            const double *a = &area.points[3 * size_t(ring.first_point)];
            EXPECT_EQ(side_of(a, a + 3, a + 6) < 0, ring.hole);
        }
        EXPECT_EQ(area.area_m2, 15);
    }
}

// Holes at holes and at the outside, points on lines, spikes, places of maps far away.
TEST(Areas, ThatTouchThemselvesAreFilled)
{
    const char *texts[] = {
        "POLYGON ((0 0, 9 0, 9 9, 0 9), (2 2, 2 4, 4 4, 4 2), (4 4, 4 6, 6 6, 6 4), (6 2, 6 4, 8 4, 8 2))",
        "POLYGON ((0 0, 9 0, 9 9, 0 9), (0 4, 2 6, 2 2))",
        "POLYGON ((0 0, 1 0, 2 0, 3 0, 3 1, 3 2, 3 3, 2 3, 1 3, 0 3, 0 2, 0 1))",
        "POLYGON ((0 0, 9 0, 9 4, 12 4, 9 4, 9 9, 0 9))",
        "POLYGON ((0 0, 5 0, 5 5, 4 5, 4 1, 3 1, 3 5, 2 5, 2 1, 1 1, 1 5, 0 5))",
        "POLYGON ((500000 5700000, 500009 5700000, 500009 5700009, 500000 5700009), (500002 5700002, 500002 5700003, "
        "500003 5700002))"};
    const double areas[] = {81 - 12, 81 - 4, 9, 81, 17, 81 - 0.5};
    for (size_t i = 0; i < 6; ++i) {
        const asset::Area area = read_area_text(texts[i]);
        EXPECT_NEAR(area.area_m2, areas[i], 1e-9) << texts[i];
        expect_filled(area);
    }
}

// Obstacles that touch at corners, three of them at one place, and corners that lie on cuts and in the way of bridges:
// a turned building and a map far from the origin round what was exact.
TEST(Areas, OfObstaclesThatTouchAreFilledWhereverTheyLie)
{
    using Rings = std::vector<asset::Ring>;
    const Rings rooms[] = {
        {{{0, 0}, {6, 0}, {6, 6}, {0, 6}},
         {{2, 3}, {2, 2}, {3, 2}},
         {{4, 3}, {3, 3}, {3, 2}},
         {{4, 2}, {5, 2}, {4, 3}}},
        {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 3}},
         {{1, 2}, {2, 2}, {0, 3}},
         {{2, 1}, {3, 2}, {2, 2}},
         {{3, 3}, {1, 3}, {2, 2}}},
        {{{4, 0}, {0, 0}, {0, 4}, {3, 4}, {3, 3}, {2, 3}, {2, 2}, {2.5, 2.5}, {3, 2}, {4, 2}}},
        {{{4, 0}, {0, 0}, {0, 4}, {4, 4}, {4, 2}}, {{2, 3}, {3, 2}, {4, 2}}, {{1, 2}, {2, 1}, {3, 2}}},
        {{{8, 8}, {8, 0}, {0, 0}, {0, 8}, {3, 8}},
         {{2, 7}, {3, 7}, {3, 8}},
         {{4, 4}, {4, 3}, {5, 4}},
         {{3, 5}, {4, 6}, {3, 6}},
         {{1, 7}, {2, 6}, {3, 6}}}};
    const double areas[] = {36 - 1.5, 16 - 2, 13.25, 14.5, 64 - 2};
    for (int room = 0; room < 5; ++room)
        for (const double turn : {0.0, 0.3, 0.7, 1.0})
            for (const double far : {0.0, 570000.1}) {
                SCOPED_TRACE(base::text_of("room %d turned by %g at %g", room, turn, far));
                Rings placed = rooms[room];
                for (asset::Ring &ring : placed)
                    for (asset::Point &p : ring)
                        p = {p.x * std::cos(turn) - p.y * std::sin(turn) + far,
                             p.x * std::sin(turn) + p.y * std::cos(turn) + 10 * far};
                asset::AreaBuilder builder;
                ASSERT_NO_THROW(builder.add_polygon(placed));
                const asset::Area area = builder.take();
                EXPECT_NEAR(area.area_m2, areas[room], far > 0 ? 1e-6 : 1e-12);
                expect_filled(area);
            }
}

// A spiral has few ears at a time.
TEST(Areas, OfManyTurnsAreFilled)
{
    std::string inner, outer;
    for (int i = 0; i < 1200; ++i) {
        const double angle = 0.05 * i, r = 1 + 0.02 * i;
        outer += base::text_of("%s%.6f %.6f", i ? ", " : "", r * std::cos(angle), r * std::sin(angle));
        inner = base::text_of(", %.6f %.6f", (r - 0.5) * std::cos(angle), (r - 0.5) * std::sin(angle)) + inner;
    }
    const asset::Area area = read_area_text("POLYGON ((" + outer + inner + "))");
    EXPECT_EQ(area.triangles.size(), 3 * 2398u);
    expect_filled(area);
}

TEST(Areas, OfADatabaseAreThoseOfTheFirstFrame)
{
#ifndef CLAQUE_HAS_SQLITE3
    GTEST_SKIP() << "this build has no sqlite3";
#endif
    for (const int version : {1, 2, 3}) {
        const Bytes bytes = database_of(jupedsim_statements(version));
        const asset::Area area = asset::read_area(bytes.data(), bytes.size());
        EXPECT_EQ(area.area_m2, 15.75) << version;
        EXPECT_EQ(area.warnings.size(), version == 1 ? 0u : 1u);
    }
}

TEST(Areas, OfRoomsHaveObstaclesAndOpenWalls)
{
#ifndef CLAQUE_HAS_EXPAT
    GTEST_SKIP() << "this build has no expat";
#endif
    const asset::Area area = read_area_text(
        "<geometry unit=\"cm\"><room><subroom><polygon><vertex px=\"0\" py=\"0\"/><vertex px=\"400\" py=\"0\"/><vertex "
        "px=\"400\" py=\"400\"/><vertex px=\"0\" py=\"0\"/></polygon><obstacle><polygon><vertex px=\"200\" "
        "py=\"100\"/><vertex px=\"300\" py=\"100\"/><vertex px=\"300\" py=\"200\"/></polygon></obstacle></subroom>"
        "<subroom><polygon><vertex px=\"0\" py=\"900\"/><vertex px=\"100\" py=\"900\"/><vertex px=\"100\" py=\"950\"/>"
        "</polygon></subroom></room></geometry>");
    EXPECT_NEAR(area.area_m2, 7.5, 1e-12);
    EXPECT_EQ(area.walls.size(), 2 * (3 + 3 + 2u));
    EXPECT_EQ(area.warnings.size(), 1u);
}

TEST(Areas, OfAScenarioWithObstaclesThatOverlapKeepTheirWalls)
{
    const std::string begin =
        "{\"scenario\": {\"topography\": {\"attributes\": {\"bounds\": {\"x\": 0, \"y\": 0, \"width\": "
        "8, \"height\": 6}, \"boundingBoxWidth\": 0.5}, \"obstacles\": [";
    const std::string box = "{\"shape\": {\"type\": \"RECTANGLE\", \"x\": 2, \"y\": 2, \"width\": 2, \"height\": 1}}";
    const std::string other = "{\"shape\": {\"type\": \"RECTANGLE\", \"x\": 3, \"y\": 1, \"width\": 2, \"height\": 3}}";
    EXPECT_NEAR(read_area_text(begin + box + "]}}}").area_m2, 35 - 2, 1e-12);
    const asset::Area both = read_area_text(begin + box + "," + other + "]}}}");
    EXPECT_NEAR(both.area_m2, 35, 1e-12);
    EXPECT_EQ(both.walls.size(), 2 * (4 + 8u));
    EXPECT_EQ(both.warnings.size(), 1u);
}

}  // namespace
}  // namespace claque::testing
