// Distances between floats in units of the last place.
#include "samples/parity/ulp.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace parity
{
namespace
{

TEST(Ulp, CountsTheFloatsBetweenTwo)
{
    EXPECT_EQ(ulp_distance(1.0f, 1.0f), 0u);
    EXPECT_EQ(ulp_distance(1.0f, std::nextafter(1.0f, 2.0f)), 1u);
    EXPECT_EQ(ulp_distance(1.0f, 2.0f), 1u << 23);
    EXPECT_EQ(ulp_distance(-1.0f, -2.0f), 1u << 23);
    EXPECT_EQ(ulp_distance(2.0f, 1.0f), 1u << 23);
    EXPECT_EQ(ulp_distance(1.0f, 1.0f + 3 * std::numeric_limits<float>::epsilon()), 3u);
}

TEST(Ulp, GoesOnAcrossZero)
{
    const float least = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(ulp_distance(0.0f, -0.0f), 0u);
    EXPECT_EQ(ulp_distance(least, -least), 2u);
    EXPECT_EQ(ulp_distance(-1.0f, 1.0f), 2u * 0x3f800000u);
}

TEST(Ulp, OfNaNIsTheMaximum)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(ulp_distance(nan, nan), ulp_most);
    EXPECT_EQ(ulp_distance(0, nan), ulp_most);
    EXPECT_EQ(ulp_distance(std::numeric_limits<float>::max(), infinity), 1u);
    EXPECT_LT(ulp_distance(-infinity, infinity), ulp_most);
}

}  // namespace
}  // namespace parity
