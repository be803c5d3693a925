#include "samples/charts/ruler.h"

#include <gtest/gtest.h>

namespace charts
{
namespace
{

using Ticks = std::vector<double>;

TEST(Ruler, linear_ends_are_round_and_include_zero)
{
    EXPECT_EQ(ruler_of(Scale::linear, 3, 119.2, 8, Zero::always).ticks, (Ticks{0, 20, 40, 60, 80, 100, 120}));
    EXPECT_EQ(ruler_of(Scale::linear, 0, 100, 10, Zero::always).to, 100);
    EXPECT_EQ(ruler_of(Scale::linear, -3, 7, 6, Zero::always).ticks, (Ticks{-4, -2, 0, 2, 4, 6, 8}));
    EXPECT_EQ(ruler_of(Scale::linear, -9, -5, 5, Zero::always).ticks.back(), 0);
}

TEST(Ruler, zero_may_be_left_out_where_it_is_far)
{
    EXPECT_EQ(ruler_of(Scale::linear, 1000, 1002, 4, Zero::near).ticks, (Ticks{1000, 1000.5, 1001, 1001.5, 1002}));
    EXPECT_EQ(ruler_of(Scale::linear, 1000, 1002, 4, Zero::always).from, 0);
    EXPECT_EQ(ruler_of(Scale::linear, 10, 100, 10, Zero::near).from, 0);
}

TEST(Ruler, one_value_has_room_above_it)
{
    const Ruler ruler = ruler_of(Scale::linear, 0, 0, 5, Zero::always);
    EXPECT_LT(ruler.from, ruler.to);
    EXPECT_EQ(ruler.share(0), 0);
}

TEST(Ruler, logarithmic_ticks_are_ones_twos_and_fives_or_decades)
{
    EXPECT_EQ(ruler_of(Scale::logarithmic, 1000, 100000, 8, Zero::always).ticks,
              (Ticks{1000, 2000, 5000, 10000, 20000, 50000, 100000}));
    EXPECT_EQ(ruler_of(Scale::logarithmic, 3, 4, 8, Zero::always).ticks, (Ticks{2, 5}));
    EXPECT_EQ(ruler_of(Scale::logarithmic, 0.2, 30000, 8, Zero::always).ticks.size(), 7u);
    EXPECT_EQ(ruler_of(Scale::logarithmic, 7, 7, 8, Zero::always).ticks, (Ticks{5, 10}));
}

TEST(Ruler, logarithmic_shares_are_equal_for_equal_ratios)
{
    const Ruler ruler = ruler_of(Scale::logarithmic, 1, 100, 8, Zero::always);
    EXPECT_NEAR(ruler.share(10), 0.5, 1e-12);
    EXPECT_NEAR(ruler.share(1), 0, 1e-12);
    EXPECT_NEAR(ruler.share(100), 1, 1e-12);
}

TEST(Ruler, every_value_is_within_the_ends_and_steps_are_few)
{
    for (const Scale scale : {Scale::linear, Scale::logarithmic})
        for (double least = 1e-6; least < 1e9; least *= 3.7)
            for (double ratio = 1; ratio < 1e9; ratio *= 4.3)
                for (const int most : {2, 6, 12}) {
                    const double largest = least * ratio;
                    const Ruler ruler = ruler_of(scale, least, largest, most, Zero::near);
                    EXPECT_LE(ruler.from, least * (1 + 1e-9));
                    EXPECT_GE(ruler.to, largest * (1 - 1e-9));
                    EXPECT_LE(ruler.ticks.size(), static_cast<size_t>(most) + 2);
                    EXPECT_GE(ruler.ticks.size(), 2u);
                }
}

TEST(Ruler, numbers_have_the_digits_that_tell_them_apart)
{
    const Ruler halves = ruler_of(Scale::linear, 0, 2, 4, Zero::always);
    EXPECT_EQ(tick_text(halves, 1.5), "1.5");
    const Ruler decades = ruler_of(Scale::logarithmic, 0.01, 100000, 8, Zero::always);
    EXPECT_EQ(tick_text(decades, 0.01), "0.01");
    EXPECT_EQ(tick_text(decades, 100000), "100\u00a0000");
    EXPECT_EQ(number_text(-1234.5, 1), "-1\u00a0234.5");
}

}  // namespace
}  // namespace charts
