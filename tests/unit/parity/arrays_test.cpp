// Deviations between arrays of positions and normals.
#include "samples/parity/arrays.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace parity
{
namespace
{

const std::vector<float> three = {0, 0, 0, 1, 2, 3, -4, 5, 6};

TEST(Arrays, EqualOnesHaveNoDeviation)
{
    const Deviation d = positions_deviation(three, three, {{7, 0, 0, 3, 1.7}});
    EXPECT_EQ(d.compared, 3u);
    EXPECT_EQ(d.max, 0);
    EXPECT_EQ(d.rms, 0);
    EXPECT_EQ(d.ulp_max, 0u);
    EXPECT_EQ(d.not_finite, 0u);
}

TEST(Arrays, DistancesAreEuclideanAndSayWhoseVertexIsWorst)
{
    std::vector<float> moved = three;
    moved[3] += 3;  // 3, 4, 0: 5
    moved[4] += 4;
    moved[8] += 1;
    const Deviation d = positions_deviation(three, moved, {{7, 0, 0, 1, 2}, {9, 1, 1, 2, 10}});
    EXPECT_DOUBLE_EQ(d.max, 5);
    EXPECT_DOUBLE_EQ(d.rms, std::sqrt((25.0 + 1) / 3));
    EXPECT_DOUBLE_EQ(d.max_relative, 0.5);
    EXPECT_EQ(d.worst_actor, 9u);
    EXPECT_EQ(d.worst_vertex, 0u);
    EXPECT_EQ(d.ulp_median, 0u);
    EXPECT_EQ(d.ulp_max, 1u << 24);  // 1 and 4: two powers of two
}

TEST(Arrays, SpansMayStandElsewhereInTheResult)
{
    const std::vector<float> other = {-4, 5, 6, 1, 2, 3};
    const Deviation d = positions_deviation(three, other, {{1, 1, 1, 1, 1}, {2, 2, 0, 1, 1}});
    EXPECT_EQ(d.compared, 2u);
    EXPECT_EQ(d.max, 0);
}

TEST(Arrays, NonFiniteNumbersAreCountedAndExcludedElsewhere)
{
    std::vector<float> broken = three;
    broken[4] = std::numeric_limits<float>::quiet_NaN();
    broken[6] = std::numeric_limits<float>::infinity();
    const Deviation d = positions_deviation(three, broken, {{1, 0, 0, 3, 1}});
    EXPECT_EQ(d.not_finite, 2u);
    EXPECT_EQ(d.max, 0);
    EXPECT_EQ(d.rms, 0);
}

TEST(Arrays, NormalsAreComparedAsDirections)
{
    const double angle = 0.01;
    const std::vector<float> a = {1, 0, 0, 0, 2, 0};
    const std::vector<float> b = {
        5 * static_cast<float>(std::cos(angle)), 5 * static_cast<float>(std::sin(angle)), 0, 0, 1, 0};
    const Deviation d = normals_deviation(a, b, {{1, 0, 0, 2, 0}});
    EXPECT_NEAR(d.max, 0.572957795, 1e-6);
    EXPECT_NEAR(d.rms, 0.572957795 / std::sqrt(2.0), 1e-6);
    EXPECT_EQ(d.worst_vertex, 0u);
    EXPECT_EQ(normals_deviation({0, 0, 1}, {0, 0, -3}, {{1, 0, 0, 1, 0}}).max, 180);
    EXPECT_EQ(normals_deviation({0, 0, 1}, {0, 0, 0}, {{1, 0, 0, 1, 0}}).max, 180);
    EXPECT_EQ(normals_deviation({0, 0, 0}, {0, 0, 0}, {{1, 0, 0, 1, 0}}).max, 0);
}

TEST(Arrays, TheSmallestAnglesAreNotLost)
{
    const Deviation d = normals_deviation({1, 0, 0}, {1, 1e-6f, 0}, {{1, 0, 0, 1, 0}});
    EXPECT_NEAR(d.max, 5.7295779e-5, 1e-10);
}

}  // namespace
}  // namespace parity
