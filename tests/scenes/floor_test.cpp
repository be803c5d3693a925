// The ground of the odeon: it lies on the drawn stone, and ways lead from each entrance to the place before each seat.
#include "samples/scenes/odeon/floor.h"

#include <claque/navigation.h>

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "samples/scenes/odeon/benches.h"
#include "samples/scenes/odeon/cavea.h"
#include "samples/scenes/odeon/seating.h"
#include "samples/scenes/odeon/stair_stone.h"
#include "samples/scenes/scenario/scenario.h"

namespace
{

using namespace scenes;

struct DestroyGround {
    void operator()(clq_navigation *p) const { clq_navigation_destroy(p); }
};
using Ground = std::unique_ptr<clq_navigation, DestroyGround>;

// As samples/scenarios/odeon-evening.toml has it.
Ground ground_of(const Floor &floor)
{
    clq_navigation_def def = clq_navigation_def_init();
    def.vertex_count = static_cast<uint32_t>(floor.vertices.size() / 3);
    def.triangle_count = static_cast<uint32_t>(floor.triangles.size() / 3);
    def.vertices = floor.vertices.data(), def.triangles = floor.triangles.data();
    std::vector<clq_byway> byways;
    for (const Floor::Strip &strip : floor.strips)
        byways.push_back(
            {{static_cast<uint32_t>(strip.outline.size() / 2), strip.outline.data(), strip.low_m, strip.high_m},
             static_cast<uint32_t>(strip.row) % CLQ_BYWAY_GROUPS});
    def.byway_count = static_cast<uint32_t>(byways.size()), def.byways = byways.data();
    def.radius_m = 0.08f, def.cell_m = 0.04f, def.max_step_m = 0.3f, def.max_slope_deg = 45;
    clq_navigation *made = nullptr;
    EXPECT_EQ(clq_navigation_create(&def, &made), CLQ_OK) << clq_last_error();
    return Ground(made);
}

struct Place {
    Theatre theatre = *odeon_scenario().theatre;
    std::vector<Seat> seats = seats_of(theatre);
    std::vector<Bench> benches = benches_of(theatre, seats);
    Floor floor = floor_of(theatre);
    Geometry stone;
    Ground ground;

    Place() : ground(ground_of(floor))
    {
        Parts parts;
        build_cavea(parts, theatre, 1);
        stone = parts.fine;
    }
};

const Place &place()
{
    static const Place made;
    return made;
}

// The highest stone at a point, below a height; the paving at 0 is below everything.
double stone_y(double x, double z, double below)
{
    double y = 0;
    const auto &vertices = place().stone.vertices();
    const auto &indices = place().stone.indices();
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
        const Vec3 &a = vertices[indices[i]].position, &b = vertices[indices[i + 1]].position,
                   &c = vertices[indices[i + 2]].position;
        const auto side = [&](const Vec3 &m, const Vec3 &n) {
            return (double(m.z) - z) * (double(n.x) - x) - (double(m.x) - x) * (double(n.z) - z);
        };
        const double u = side(b, c), v = side(c, a), w = side(a, b), area = u + v + w;
        if (area <= 0 || u < 0 || v < 0 || w < 0) continue;
        const double at = (u * double(a.y) + v * double(b.y) + w * double(c.y)) / area;
        if (at < below) y = std::max(y, at);
    }
    return y;
}

double level_m(const double *a, const double *b) { return std::hypot(a[0] - b[0], a[2] - b[2]); }

TEST(FloorOfTheOdeon, LiesOnTheStone)
{
    const Floor &floor = place().floor;
    const Gangway *stairs = place().theatre.gangways.data();
    size_t on_stairs = 0;
    for (size_t i = 0; i + 2 < floor.triangles.size(); i += 3) {
        double at[3] = {0, 0, 0};
        for (size_t k = 0; k < 3; ++k)
            for (size_t axis = 0; axis < 3; ++axis) at[axis] += floor.vertices[3 * floor.triangles[i + k] + axis] / 3;
        const double angle = std::atan2(at[0], -at[2]) * 180 / 3.14159265358979;
        double aside_m = 9;
        for (size_t g = 0; g < place().theatre.gangways.size(); ++g)
            aside_m = std::min(aside_m, std::abs(stairs[g].at_deg - angle) * std::hypot(at[0], at[2]) / 57.3);
        // Half a step up or down on stairs, which are ramps here; elsewhere a joint.
        const bool is_ramp = aside_m < 0.4 && at[1] > 0.01;
        on_stairs += is_ramp;
        EXPECT_NEAR(stone_y(at[0], at[2], at[1] + 0.13), at[1], is_ramp ? 0.125 : 0.012)
            << at[0] << ", " << at[1] << ", " << at[2];
    }
    EXPECT_GT(on_stairs, 200u);
}

// What feet stand on, against the triangles that are drawn; not within a centimetre of the edges of treads.
TEST(StairStone, IsTheStoneThatIsDrawn)
{
    const Theatre &theatre = place().theatre;
    const StairStone stone(theatre);
    size_t compared = 0;
    for (const Gangway &gangway : theatre.gangways)
        for (const Tread &tread : treads_of(theatre, gangway))
            for (const double share : {0.03, 0.5, 0.97}) {
                const double radius = tread.from_m + share * (tread.to_m - tread.from_m);
                const double angle = gangway.at_deg * 3.14159265358979 / 180 + 0.2 / radius;
                const double point[3] = {radius * std::sin(angle), tread.y + 0.1, -radius * std::cos(angle)};
                const double y = stone.height_m(point);
                EXPECT_NEAR(y, stone_y(point[0], point[2], tread.y + 0.15), 0.012)
                    << radius << " m at " << gangway.at_deg;
                ++compared;
            }
    EXPECT_GT(compared, 300u);
}

TEST(StairStone, IsKnownOnStairsAlone)
{
    const StairStone stone(place().theatre);
    const double centre[3] = {0, 0, 0}, among_seats[3] = {3.5, 2, -9}, above[3] = {0, 40, -10}, below[3] = {0, -3, -10};
    for (const double *point : {centre, among_seats, above, below})
        EXPECT_TRUE(std::isnan(stone.height_m(point))) << point[0] << ", " << point[1] << ", " << point[2];
}

TEST(FloorOfTheOdeon, LeadsFromEachEntranceToThePlaceBeforeEachSeat)
{
    size_t found = 0;
    const auto entrances = entrances_of(place().theatre);
    for (size_t b = 0; b < place().benches.size(); ++b) {
        const Bench &bench = place().benches[b];
        for (const size_t seat : {bench.seats.front(), bench.seats.back()}) {
            const clq_transform sat = sit_down(place().seats[seat], 0, 1);
            const auto &from = entrances[(b + seat) % entrances.size()];
            double points[3 * 256];
            clq_way way = clq_way_init();
            ASSERT_EQ(clq_navigation_find_way(place().ground.get(), from.data(), sat.position, 256, points, &way),
                      CLQ_OK);
            ASSERT_GT(way.point_count, 1u);
            const double *end = points + 3 * (way.point_count - 1);
            EXPECT_TRUE(way.complete) << "row " << bench.row + 1 << " at " << place().seats[seat].angle_deg;
            EXPECT_LT(level_m(end, sat.position), 0.35) << "row " << bench.row + 1;
            // Beside the stairs the mesh slopes from them to the row, by half a step at most.
            const bool beside = seat == bench.seats.back();
            EXPECT_NEAR(end[1], place().seats[seat].step_y, beside ? 0.22 : 0.05) << "row " << bench.row + 1;
            EXPECT_LT(way.length, 75);
            ++found;
        }
    }
    EXPECT_EQ(found, 2 * place().benches.size());
}

// No way leads over seats: of its row only the strip behind the backs of those in front is ground.
TEST(FloorOfTheOdeon, HasNoWayOverTheSeats)
{
    for (const Seat &seat : place().seats) {
        const double radius = std::hypot(seat.x, seat.z);
        const double on[3] = {seat.x * (1 + 0.15 / radius), seat.y, seat.z * (1 + 0.15 / radius)};
        double nearest[3];
        bool found = false;
        ASSERT_EQ(clq_navigation_find_nearest(place().ground.get(), on, 0.2, nearest, &found), CLQ_OK);
        ASSERT_FALSE(found) << "row " << seat.row + 1 << " at " << seat.angle_deg;
    }
}

TEST(BenchesOfTheOdeon, HoldEachSeatOnceAndEndAtTheirGangway)
{
    std::vector<int> times(place().seats.size(), 0);
    for (const Bench &bench : place().benches) {
        double before_m = 1e9;
        for (const size_t i : bench.seats) {
            ++times[i];
            const Seat &seat = place().seats[i];
            EXPECT_EQ(seat.row, bench.row);
            const double entry[3] = {seat.x, seat.y, seat.z};
            const double away_m = level_m(entry, bench.entry.data());
            EXPECT_LT(away_m, before_m);
            before_m = away_m;
        }
        EXPECT_LT(before_m, 1.3) << "row " << bench.row + 1;
    }
    for (size_t i = 0; i < times.size(); ++i) EXPECT_EQ(times[i], 1) << i;
}

}  // namespace
