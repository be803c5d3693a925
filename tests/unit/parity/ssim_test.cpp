// Values of scikit-image 0.19.3 for the same pictures (structural_similarity of luma, gaussian_weights, sigma 1.5, no
// sample covariance; its manual says that this agrees with Wang et al.), and consequences of the formula.
#include "samples/parity/ssim.h"

#include <gtest/gtest.h>

#include "tests/unit/parity/test_pictures.h"

namespace parity
{
namespace
{

TEST(Ssim, AgreesWithScikitImage)
{
    const Picture small = pattern(48, 32, 0), large = pattern(64, 64, 0);
    EXPECT_NEAR(mean_ssim(small, noisy_pattern(48, 32)), 0.9891254129914226, 1e-9);
    EXPECT_NEAR(mean_ssim(small, pattern(48, 32, 1)), -0.04128525980180784, 1e-9);
    EXPECT_NEAR(mean_ssim(small, inverted(small)), -0.9615956843995659, 1e-9);
    EXPECT_NEAR(mean_ssim(large, noisy_pattern(64, 64)), 0.9876146123102131, 1e-9);
    EXPECT_NEAR(mean_ssim(large, pattern(64, 64, 1)), -0.027456686103740725, 1e-9);
    EXPECT_NEAR(mean_ssim(large, inverted(large)), -0.9598311689962817, 1e-9);
}

TEST(Ssim, OfEqualPicturesIsOne) { EXPECT_NEAR(mean_ssim(pattern(20, 11, 1), pattern(20, 11, 1)), 1, 1e-12); }

TEST(Ssim, OfPlainPicturesIsTheirLuminanceTerm)
{
    const double c1 = 2.55 * 2.55;
    const double expected = (2 * 100.0 * 150 + c1) / (100.0 * 100 + 150.0 * 150 + c1);
    EXPECT_NEAR(mean_ssim(filled(11, 11, 100), filled(11, 11, 150)), expected, 1e-9);
}

}  // namespace
}  // namespace parity
