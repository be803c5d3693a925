// Reading walkable areas takes time in proportion to the file, up to the sorting of edges, however holes lie.
#include <cmath>

#include <gtest/gtest.h>

#include "lib/asset/areas/area.h"
#include "lib/base/error.h"
#include "work_counter.h"

namespace claque::testing
{
namespace
{

constexpr uint64_t most_area_ratio = 16;  // of ten times the count

uint64_t area_steps(const std::string &text, size_t holes)
{
    size_t rings = 0;
    const uint64_t out = blocks_entered(
        [&] { rings = asset::read_area(reinterpret_cast<const uint8_t *>(text.data()), text.size()).rings.size(); });
    EXPECT_EQ(rings, 1 + holes);
    return out;
}

void expect_in_proportion(const char *name, std::string (*make)(size_t), size_t few, bool holes)
{
    const uint64_t least = area_steps(make(few), holes ? few : 0),
                   most = area_steps(make(10 * few), holes ? 10 * few : 0);
    EXPECT_GT(least, 3000u) << name << ": nothing is counted";
    EXPECT_LE(most, most_area_ratio * least) << name;
    ::testing::Test::RecordProperty(name, std::to_string(double(most) / double(least)));
}

std::string triangle(double x, double y, double width = 1)
{
    return base::text_of(", (%.9g %.9g, %.9g %.9g, %.9g %.9g)", x, y, x + width, y, x, y + 1);
}

std::string square(double side)
{
    return base::text_of("POLYGON ((0 0, %.9g 0, %.9g %.9g, 0 %.9g)", side, side, side, side);
}

std::string in_a_grid(size_t count)
{
    const size_t side = static_cast<size_t>(std::sqrt(double(count))) + 1;
    std::string text = square(3 * double(side) + 2);
    for (size_t i = 0; i < count; ++i) text += triangle(1 + 3 * double(i % side), 1 + 3 * double(i / side));
    return text + ")";
}

std::string in_a_column(size_t count)
{
    std::string text = square(3 * double(count) + 2);
    for (size_t i = 0; i < count; ++i) text += triangle(1, 1 + 3 * double(i), double(count));
    return text + ")";
}

std::string in_a_row(size_t count)
{
    std::string text = square(3 * double(count) + 2);
    for (size_t i = 0; i < count; ++i) text += triangle(1 + 3 * double(i), 1);
    return text + ")";
}

std::string down_a_slope(size_t count)
{
    std::string text = square(3 * double(count) + 2);
    for (size_t i = 0; i < count; ++i) text += triangle(1 + 3 * double(i), 3 * double(count - i));
    return text + ")";
}

TEST(AreaWork, OfHolesGrowsWithTheirNumber)
{
    expect_in_proportion("grid", in_a_grid, 300, true);
    expect_in_proportion("column", in_a_column, 300, true);
    expect_in_proportion("row", in_a_row, 300, true);
    expect_in_proportion("slope", down_a_slope, 300, true);
}

std::string vadere_obstacles(size_t count)
{
    const size_t side = static_cast<size_t>(std::sqrt(double(count))) + 1;
    std::string text = base::text_of(
        "{\"scenario\": {\"topography\": {\"attributes\": {\"bounds\": {\"x\": 0, \"y\": "
        "0, \"width\": %zu, \"height\": %zu}}, \"obstacles\": [",
        3 * side, 3 * side);
    for (size_t i = 0; i < count; ++i)
        text += base::text_of(
            "%s{\"shape\": {\"type\": \"RECTANGLE\", \"x\": %zu, \"y\": %zu, \"width\": 1, "
            "\"height\": 1}}",
            i ? ", " : "", 1 + 3 * (i % side), 1 + 3 * (i / side));
    return text + "]}}}";
}

TEST(AreaWork, OfObstaclesGrowsWithTheirNumber) { expect_in_proportion("obstacles", vadere_obstacles, 240, true); }

std::string circle(size_t count)
{
    std::string text = "POLYGON ((100 0";
    for (size_t i = 1; i < count; ++i)
        text += base::text_of(", %.9g %.9g", 100 * std::cos(2 * M_PI * double(i) / double(count)),
                              100 * std::sin(2 * M_PI * double(i) / double(count)));
    return text + "))";
}

// Has few ears at a time.
std::string spiral(size_t count)
{
    std::string inner, outer;
    for (size_t i = 0; i < count / 2; ++i) {
        const double angle = 0.05 * double(i), r = 1 + 0.02 * double(i);
        outer += base::text_of("%s%.9g %.9g", i ? ", " : "", r * std::cos(angle), r * std::sin(angle));
        inner = base::text_of(", %.9g %.9g", (r - 0.5) * std::cos(angle), (r - 0.5) * std::sin(angle)) + inner;
    }
    return "POLYGON ((" + outer + inner + "))";
}

TEST(AreaWork, OfPointsGrowsWithTheirNumber)
{
    expect_in_proportion("circle", circle, 900, false);
    expect_in_proportion("spiral", spiral, 900, false);
}

}  // namespace
}  // namespace claque::testing
