// The flags of this project round wherever the language says so, in code that is compiled as the library is.
#include <array>

#include <gtest/gtest.h>

namespace claque::test
{

namespace
{

// Neighbours invite a compiler to convert them as one vector.
__attribute__((noinline)) std::array<double, 4> through_floats(const std::array<double, 4> &values)
{
    const std::array<float, 4> floats = {float(values[0]), float(values[1]), float(values[2]), float(values[3])};
    return {floats[0], floats[1], floats[2], floats[3]};
}

__attribute__((noinline)) std::array<double, 2> pair_through_floats(double a, double b)
{
    const float x = float(a), y = float(b);
    return {x, y};
}

}  // namespace

TEST(Rounding, DoublesThatBecomeFloatsAndThenDoublesAreRounded)
{
    const std::array<double, 4> values = {1 / 3.0, 1 / 7.0, 1 / 11.0, 1 / 13.0};
    const std::array<double, 4> four = through_floats(values);
    const std::array<double, 2> two = pair_through_floats(values[0], values[1]);
    for (size_t i = 0; i < values.size(); ++i) {
        volatile float rounded = float(values[i]);
        EXPECT_EQ(four[i], double(rounded)) << i;
        if (i < 2) {
            EXPECT_EQ(two[i], double(rounded)) << i;
        }
    }
}

}  // namespace claque::test
