// Deviations between depth maps.
#include "samples/parity/depth.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace parity
{
namespace
{

TEST(Depth, IsComparedWhereSomethingIs)
{
    Map<float> a(10, 10, 1), b = a;
    a.values[0] = b.values[0] = 0.5f;
    a.values[1] = 0.25f;  // background in the result
    const DepthDeviation d = depth_deviation(a, b, {});
    EXPECT_EQ(d.compared, 2u);
    EXPECT_DOUBLE_EQ(d.max, 0.75);
    EXPECT_DOUBLE_EQ(d.rms, std::sqrt(0.75 * 0.75 / 2));
    EXPECT_EQ(d.max_x, 1);
    EXPECT_EQ(d.max_y, 0);
}

TEST(Depth, IsComparedWhereThePixelsCount)
{
    Map<float> a(4, 1, 0.5f), b = a;
    b.values[1] = 0.75f, b.values[2] = 0.625f;
    const DepthDeviation d = depth_deviation(a, b, {1, 0, 1, 1});
    EXPECT_EQ(d.compared, 3u);
    EXPECT_DOUBLE_EQ(d.max, 0.125);
    EXPECT_EQ(d.max_x, 2);
}

TEST(Depth, HasQuantiles)
{
    Map<float> a(100, 100, 0.5f), b = a;
    for (size_t i = 0; i < 10; ++i) b.values[i * 7] = 0.75f;  // one in a thousand
    EXPECT_EQ(depth_deviation(a, b, {}).p99_9, 0);
    EXPECT_EQ(depth_deviation(a, b, {}).median, 0);
    b.values[1] = b.values[2] = b.values[3] = 0.75f;
    EXPECT_EQ(depth_deviation(a, b, {}).p99_9, 0.25);
    EXPECT_EQ(depth_deviation(a, Map<float>(100, 100, 0.625f), {}).median, 0.125);
}

TEST(Depth, NonFiniteNumbersAreCounted)
{
    Map<float> a(2, 1, 0.5f), b = a;
    b.values[1] = std::numeric_limits<float>::quiet_NaN();
    const DepthDeviation d = depth_deviation(a, b, {});
    EXPECT_EQ(d.not_finite, 1u);
    EXPECT_EQ(d.max, 0);
}

TEST(Depth, OfTheBackgroundIsNotCompared)
{
    EXPECT_EQ(depth_deviation(Map<float>(3, 3, 1), Map<float>(3, 3, 1), {}).compared, 0u);
}

}  // namespace
}  // namespace parity
