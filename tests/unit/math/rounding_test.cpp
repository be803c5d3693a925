// The flags of this project round wherever the language says so, in code that is compiled as the library is.
#include <gtest/gtest.h>

namespace claque::test
{

namespace
{

// Neighbours invite a compiler to convert them as one vector.
__attribute__((noinline)) void pair_through_floats(const double *in, double *out)
{
    const float a = float(in[0]), b = float(in[1]);
    out[0] = a, out[1] = b;
}

__attribute__((noinline)) void four_through_floats(const double *in, double *out)
{
    const float a = float(in[0]), b = float(in[1]), c = float(in[2]), d = float(in[3]);
    out[0] = a, out[1] = b, out[2] = c, out[3] = d;
}

}  // namespace

TEST(Rounding, DoublesThatBecomeFloatsAndThenDoublesAreRounded)
{
    double values[4], two[2], four[4];
    for (int i = 0; i < 4; ++i) {
        volatile double unknown = 1.0 / (3 + 2 * i);  // to the compiler
        values[i] = unknown;
    }
    pair_through_floats(values, two), four_through_floats(values, four);
    for (int i = 0; i < 4; ++i) {
        volatile float rounded = float(values[i]);
        EXPECT_EQ(four[i], double(rounded)) << i;
        if (i < 2) {
            EXPECT_EQ(two[i], double(rounded)) << i;
        }
    }
}

}  // namespace claque::test
