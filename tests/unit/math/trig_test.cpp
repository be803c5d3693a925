// Trigonometric functions, compared with the C library's.
#include "lib/math/trig.h"

#include <cmath>

#include <gtest/gtest.h>

namespace claque::math
{

TEST(Trig, ArcsAreThoseOfTheCLibraryToTheLastFewBits)
{
    for (int i = -20000; i <= 20000; ++i) {
        const double x = i / 20000.0;
        EXPECT_NEAR(acos(x), std::acos(x), 2e-15) << x;
        EXPECT_NEAR(atan(x * 50), std::atan(x * 50), 1e-15) << x;
    }
}

TEST(Trig, Atan2CoversTheWholeCircle)
{
    for (int i = -3600; i <= 3600; ++i) {
        const double a = i * 3.14159265358979 / 3600;
        EXPECT_NEAR(atan2(std::sin(a) * 7, std::cos(a) * 7), std::atan2(std::sin(a) * 7, std::cos(a) * 7), 1e-15) << i;
    }
    EXPECT_EQ(atan2(0, 0), 0);
    EXPECT_DOUBLE_EQ(atan2(0, -1), pi);
    EXPECT_DOUBLE_EQ(atan2(-3, 0), -pi / 2);
}

TEST(Trig, CosinesThatRoundingPushedPastOneStillHaveAnArc)
{
    EXPECT_EQ(acos(1.0000001), 0);
    EXPECT_EQ(acos(-1.0000001), pi);
}

TEST(Trig, TangentOfHalfAFieldOfView) { EXPECT_NEAR(tan(0.5), std::tan(0.5), 1e-15); }

}  // namespace claque::math
