// Values of scikit-image 0.19.3's peak_signal_noise_ratio for the same pictures, and known values.
#include "samples/parity/psnr.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/parity/test_pictures.h"

namespace parity
{
namespace
{

TEST(Psnr, IsInfiniteOfEqualPictures)
{
    const ColourDeviation d = colour_deviation(pattern(8, 8, 0), pattern(8, 8, 0));
    EXPECT_TRUE(std::isinf(d.psnr_db));
    EXPECT_EQ(d.max, 0);
    EXPECT_EQ(d.share_over(0), 0);
}

TEST(Psnr, HasTheKnownValuesOfConstantDifferences)
{
    EXPECT_NEAR(colour_deviation(filled(4, 4, 100), filled(4, 4, 101)).psnr_db, 48.13080361, 1e-8);
    EXPECT_NEAR(colour_deviation(filled(4, 4, 0), filled(4, 4, 255)).psnr_db, 0, 1e-12);
}

TEST(Psnr, AgreesWithScikitImage)
{
    const Picture small = pattern(48, 32, 0), large = pattern(64, 64, 0);
    EXPECT_NEAR(colour_deviation(small, noisy_pattern(48, 32)).psnr_db, 31.822324359599232, 1e-9);
    EXPECT_NEAR(colour_deviation(small, pattern(48, 32, 1)).psnr_db, 8.265344139454294, 1e-9);
    EXPECT_NEAR(colour_deviation(small, inverted(small)).psnr_db, 4.777520323244762, 1e-9);
    EXPECT_NEAR(colour_deviation(large, noisy_pattern(64, 64)).psnr_db, 31.813752315887577, 1e-9);
}

TEST(Psnr, FractionsCountPixelsByTheirWorstChannel)
{
    Picture a = filled(10, 10, 50), b = a;
    b.rgb[0] = 51;           // one pixel off by 1
    b.rgb[3 * 10 + 1] = 53;  // one by 3, in two channels
    b.rgb[3 * 10 + 2] = 48;
    b.rgb[3 * 99 + 2] = 90;  // one by 40
    const ColourDeviation d = colour_deviation(a, b);
    EXPECT_EQ(d.max, 40);
    EXPECT_DOUBLE_EQ(d.share_over(0), 0.03);
    EXPECT_DOUBLE_EQ(d.share_over(1), 0.02);
    EXPECT_DOUBLE_EQ(d.share_over(2), 0.02);
    EXPECT_DOUBLE_EQ(d.share_over(3), 0.01);
    EXPECT_DOUBLE_EQ(d.share_over(8), 0.01);
    EXPECT_DOUBLE_EQ(d.share_over(255), 0);
    std::vector<uint8_t> first_row(100, 0);
    std::fill(first_row.begin(), first_row.begin() + 10, 1);
    EXPECT_DOUBLE_EQ(colour_deviation(a, b, first_row).share_over(0), 0.1);
    EXPECT_DOUBLE_EQ(colour_deviation(a, b, first_row).psnr_db, d.psnr_db);
}

}  // namespace
}  // namespace parity
