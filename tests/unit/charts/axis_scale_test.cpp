// Axes of charts: round ends, ticks and labels.
#include "samples/charts/axis_scale.h"

#include <gtest/gtest.h>

namespace charts
{
namespace
{

using Ticks = std::vector<double>;

TEST(AxisScale, LinearEndsAreRoundAndIncludeZero)
{
    EXPECT_EQ(axis_scale_of(Scale::linear, 3, 119.2, 8, Zero::always).ticks, (Ticks{0, 20, 40, 60, 80, 100, 120}));
    EXPECT_EQ(axis_scale_of(Scale::linear, 0, 100, 10, Zero::always).to, 100);
    EXPECT_EQ(axis_scale_of(Scale::linear, -3, 7, 6, Zero::always).ticks, (Ticks{-4, -2, 0, 2, 4, 6, 8}));
    EXPECT_EQ(axis_scale_of(Scale::linear, -9, -5, 5, Zero::always).ticks.back(), 0);
}

TEST(AxisScale, ZeroMayBeLeftOutWhereItIsFar)
{
    EXPECT_EQ(axis_scale_of(Scale::linear, 1000, 1002, 4, Zero::near).ticks, (Ticks{1000, 1000.5, 1001, 1001.5, 1002}));
    EXPECT_EQ(axis_scale_of(Scale::linear, 1000, 1002, 4, Zero::always).from, 0);
    EXPECT_EQ(axis_scale_of(Scale::linear, 10, 100, 10, Zero::near).from, 0);
}

TEST(AxisScale, OneValueHasRoomAboveIt)
{
    const AxisScale axis_scale = axis_scale_of(Scale::linear, 0, 0, 5, Zero::always);
    EXPECT_LT(axis_scale.from, axis_scale.to);
    EXPECT_EQ(axis_scale.share(0), 0);
}

TEST(AxisScale, LogarithmicTicksAreOnesTwosAndFivesOrDecades)
{
    EXPECT_EQ(axis_scale_of(Scale::logarithmic, 1000, 100000, 8, Zero::always).ticks,
              (Ticks{1000, 2000, 5000, 10000, 20000, 50000, 100000}));
    EXPECT_EQ(axis_scale_of(Scale::logarithmic, 3, 4, 8, Zero::always).ticks, (Ticks{2, 5}));
    EXPECT_EQ(axis_scale_of(Scale::logarithmic, 0.2, 30000, 8, Zero::always).ticks.size(), 7u);
    EXPECT_EQ(axis_scale_of(Scale::logarithmic, 7, 7, 8, Zero::always).ticks, (Ticks{5, 10}));
}

TEST(AxisScale, LogarithmicSharesAreEqualForEqualRatios)
{
    const AxisScale axis_scale = axis_scale_of(Scale::logarithmic, 1, 100, 8, Zero::always);
    EXPECT_NEAR(axis_scale.share(10), 0.5, 1e-12);
    EXPECT_NEAR(axis_scale.share(1), 0, 1e-12);
    EXPECT_NEAR(axis_scale.share(100), 1, 1e-12);
}

TEST(AxisScale, EveryValueIsWithinTheEndsAndStepsAreFew)
{
    for (const Scale scale : {Scale::linear, Scale::logarithmic})
        for (double least = 1e-6; least < 1e9; least *= 3.7)
            for (double ratio = 1; ratio < 1e9; ratio *= 4.3)
                for (const int most : {2, 6, 12}) {
                    const double largest = least * ratio;
                    const AxisScale axis_scale = axis_scale_of(scale, least, largest, most, Zero::near);
                    EXPECT_LE(axis_scale.from, least * (1 + 1e-9));
                    EXPECT_GE(axis_scale.to, largest * (1 - 1e-9));
                    EXPECT_LE(axis_scale.ticks.size(), static_cast<size_t>(most) + 2);
                    EXPECT_GE(axis_scale.ticks.size(), 2u);
                }
}

TEST(AxisScale, NumbersHaveTheDigitsThatTellThemApart)
{
    const AxisScale halves = axis_scale_of(Scale::linear, 0, 2, 4, Zero::always);
    EXPECT_EQ(tick_text(halves, 1.5), "1.5");
    const AxisScale decades = axis_scale_of(Scale::logarithmic, 0.01, 100000, 8, Zero::always);
    EXPECT_EQ(tick_text(decades, 0.01), "0.01");
    EXPECT_EQ(tick_text(decades, 100000), "100\u00a0000");
    EXPECT_EQ(number_text(-1234.5, 1), "-1\u00a0234.5");
}

}  // namespace
}  // namespace charts
