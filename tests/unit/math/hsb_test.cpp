// Conversion of HSB to RGB.
#include "lib/math/hsb.h"

#include <cmath>

#include <gtest/gtest.h>

namespace claque::math
{

namespace
{

// The other usual formulation: six sectors of the hue circle.
void by_sectors(double h, double s, double b, double out[3])
{
    const double x = h / 60, f = x - std::floor(x);
    const double p = b * (1 - s), q = b * (1 - s * f), t = b * (1 - s * (1 - f));
    const double table[6][3] = {{b, t, p}, {q, b, p}, {p, b, t}, {p, q, b}, {t, p, b}, {b, p, q}};
    for (int k = 0; k < 3; ++k) out[k] = table[int(std::floor(x)) % 6][k];
}

}  // namespace

TEST(Hsb, AgreesWithTheSixSectors)
{
    for (int h = 0; h < 360; ++h)
        for (int s = 0; s <= 4; ++s)
            for (int b = 0; b <= 4; ++b) {
                double expected[3], got[3];
                by_sectors(h + 0.25, s / 4.0, b / 4.0, expected);
                hsb_to_rgb(h + 0.25, s / 4.0, b / 4.0, got);
                for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[k], expected[k], 1e-12) << h << " " << s << " " << b;
            }
}

TEST(Hsb, AHueRangeMayWrapPastRed)
{
    EXPECT_DOUBLE_EQ(lerp_hue(350, 20, 0), 350);
    EXPECT_DOUBLE_EQ(lerp_hue(350, 20, 0.5), 5);
    EXPECT_NEAR(lerp_hue(350, 20, 0.999), 19.97, 1e-9);
    EXPECT_DOUBLE_EQ(lerp_hue(40, 60, 0.5), 50);
    EXPECT_DOUBLE_EQ(lerp_hue(40, 40, 0.5), 40);
}

TEST(Hsb, BytesAreTheNearest)
{
    const double rgb[3] = {0.5, 1.2, -3};
    EXPECT_EQ(rgb8_of(rgb).r, 128);
    EXPECT_EQ(rgb8_of(rgb).g, 255);
    EXPECT_EQ(rgb8_of(rgb).b, 0);
}

}  // namespace claque::math
