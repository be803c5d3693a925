// Trigonometric functions, compared with the C library's.
#include "lib/math/trig.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

namespace
{

// Some C libraries are exact for small angles alone. The parts of a quarter turn are short, so that products are exact.
long double exact_sin(double x, int quarters = 0)
{
    const long long count = std::llround(x * (2 / pi));
    const long double n = count;
    const long double rest = ((x - n * 0x1.921fb544p+0L) - n * 0x1.0b4611a6p-34L) - n * 0x1.3198a2e037073p-69L;
    const long long quarter = (count + quarters) & 3;
    const long double size = quarter & 1 ? std::cos(rest) : std::sin(rest);
    return quarter & 2 ? -size : size;
}
long double exact_cos(double x) { return exact_sin(x, 1); }

// In units of the last place of the exact value.
double error_of(double got, long double exact)
{
    int exponent = 0;
    std::frexp(static_cast<double>(exact), &exponent);
    return static_cast<double>(std::fabs(got - exact)) / std::ldexp(1.0, exponent - 53);
}

// Angles of all sizes up to a million, the same in each run.
std::vector<double> angles()
{
    std::vector<double> out;
    uint64_t state = 1;
    for (int i = 0; i < 60000; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        out.push_back((double(state >> 11) / double(1ull << 52) - 1) * (i % 3 == 0 ? 1 : i % 3 == 1 ? 30 : 1e6));
    }
    return out;
}

}  // namespace

TEST(Trig, SinesAndCosinesAreWithinAUnitOfTheLastPlace)
{
    double sine = 0, cosine = 0, tangent = 0;
    for (const double x : angles()) {
        sine = std::max(sine, error_of(sin(x), exact_sin(x)));
        cosine = std::max(cosine, error_of(cos(x), exact_cos(x)));
        tangent = std::max(tangent, error_of(tan(x), exact_sin(x) / exact_cos(x)));
    }
    EXPECT_LT(sine, 0.9);
    EXPECT_LT(cosine, 0.9);
    EXPECT_LT(tangent, 3);
}

TEST(Trig, SinesOfFloatsAreWithinSixTenthsOfAUnitOfTheLastPlace)
{
    constexpr double units = 0x1p-29;  // of double in those of float
    double sine = 0, cosine = 0;
    for (const double angle : angles()) {
        const float x = static_cast<float>(angle);
        sine = std::max(sine, units * error_of(double(sin(x)), exact_sin(double(x))));
        cosine = std::max(cosine, units * error_of(double(cos(x)), exact_cos(double(x))));
    }
    EXPECT_LT(sine, 0.6);
    EXPECT_LT(cosine, 0.6);
}

TEST(Trig, BitsOfKnownAnglesStay)
{
    EXPECT_EQ(sin(1.0), 0x1.aed548f090ceep-1);
    EXPECT_EQ(cos(1.0), 0x1.14a280fb5068cp-1);
    EXPECT_EQ(sin(pi), 0x1.1a62633145c07p-53);
    EXPECT_EQ(sin(-0.0), 0);
    EXPECT_EQ(cos(0.0), 1);
    EXPECT_EQ(sin(1.0f), 0x1.aed548p-1f);
    EXPECT_EQ(cos(1.0f), 0x1.14a28p-1f);
}

TEST(Trig, AnglesBeyondAMillionAreThoseOfANeighbour)
{
    for (const double x : {1e6, 12345678.125, 4e8}) {
        const double room = x * 1.2e-16;  // half a unit of the last place of x
        EXPECT_NEAR(sin(x), static_cast<double>(exact_sin(x)), room) << x;
        EXPECT_NEAR(cos(-x), static_cast<double>(exact_cos(x)), room) << x;
    }
    EXPECT_TRUE(std::isnan(sin(INFINITY)) && std::isnan(cos(-INFINITY)) && std::isnan(sin(NAN)));
    EXPECT_LE(std::fabs(sin(1e300)), 1);
}

TEST(Trig, PowersAreThoseOfTheCLibraryToTheLastFewBits)
{
    for (const double x : {0.001, 0.3, 1.0, 1.7, 255.0 / 94, 40.0})
        for (const double y : {-16.0, -2.4, -1 / 2.25, 0.0, 1 / 2.4, 0.5, 1.0, 2.25, 3.0, 11.3})
            EXPECT_NEAR(pow(x, y) / std::pow(x, y), 1, 1e-14) << x << " to the " << y;
    EXPECT_EQ(pow(3.0, 5.0), 243);
    EXPECT_EQ(pow(0.25, -0.5), 2);
    EXPECT_EQ(pow(0.0, 2.4), 0);
}

}  // namespace claque::math
