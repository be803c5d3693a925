// LDR-FLIP compared with published values and with a second evaluation (direct_flip.h). The pictures of the authors'
// published means are not available here. Published values of reproducible pictures are: 0.9514 for linear greys of 0.1
// and 0.9 as halves (OpenImageIO's test suite, whose FLIP its authors compare with NVIDIA's), 67.02 pixels per degree
// by default, the matrix from XYZ to RGB, and that green and blue are farthest apart.
#include "samples/parity/flip.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/parity/direct_flip.h"
#include "tests/unit/parity/test_pictures.h"

namespace parity
{
namespace
{

using flip::Colour;

const double ppd = pixels_per_degree();

void expect_as_directly(const Picture &a, const Picture &b, double pixels_a_degree)
{
    std::vector<parity_test::Rgb> of_a, of_b;
    for (size_t i = 0; i < a.rgb.size(); i += 3) {
        of_a.push_back(parity_test::linear_of_srgb(a.rgb[i], a.rgb[i + 1], a.rgb[i + 2]));
        of_b.push_back(parity_test::linear_of_srgb(b.rgb[i], b.rgb[i + 1], b.rgb[i + 2]));
    }
    const std::vector<double> expected = parity_test::direct_flip(of_a, of_b, a.width, a.height, pixels_a_degree);
    const Map<float> map = flip_map(a, b, pixels_a_degree);
    double worst = 0, sum = 0;
    for (size_t i = 0; i < expected.size(); ++i) {
        worst = std::max(worst, std::fabs(expected[i] - double(map.values[i])));
        sum += expected[i];
    }
    // Where features are equal but for rounding, the error's square root is in the exponent: 1e-7 becomes 3e-4.
    EXPECT_LT(worst, 1e-3);
    EXPECT_NEAR(mean_of(map), sum / static_cast<double>(expected.size()), 1e-5);
}

TEST(Flip, HasThePublishedValueOfTwoGreys)
{
    const float dark = 0.099975586f, light = 0.89990234f;
    const Map<float> map =
        flip_map(Map<Colour>(64, 64, {dark, dark, dark}), Map<Colour>(64, 64, {light, light, light}), ppd);
    EXPECT_NEAR(mean_of(map), 0.9514, 0.00005);
    EXPECT_NEAR(*std::max_element(map.values.begin(), map.values.end()), 0.9514f, 0.00005f);
}

TEST(Flip, LooksFromThePublishedDistanceByDefault) { EXPECT_NEAR(ppd, 67.02, 0.005); }

TEST(Flip, HasThePublishedMatrixFromXyz)
{
    // Opponent colours of X, Y and Z alone.
    const float x = 1 / 0.950428545f, z = 1 / 1.088900371f;
    const Colour of_x = flip::linear_of_opponent({-16, 500 * x, 0}),
                 of_z = flip::linear_of_opponent({-16, 0, -200 * z});
    const Colour of_y = flip::linear_of_opponent({100, -500, 200});
    const float published[3][3] = {{3.241003275f, -1.537398934f, -0.498615861f},
                                   {-0.969224334f, 1.875930071f, 0.041554224f},
                                   {0.055639423f, -0.204011202f, 1.057148933f}};
    for (size_t r = 0; r < 3; ++r) {
        EXPECT_NEAR(of_x[r], published[r][0], 2e-6);
        EXPECT_NEAR(of_y[r], published[r][1], 2e-6);
        EXPECT_NEAR(of_z[r], published[r][2], 2e-6);
    }
}

TEST(Flip, GreenAndBlueAreFurthestApart)
{
    std::vector<Colour> cube;
    for (int i = 0; i < 125; ++i)
        cube.push_back(flip::hunt_lab_of({float(i % 5) / 4, float(i / 5 % 5) / 4, float(i / 25) / 4}));
    float most = 0;
    for (const Colour &a : cube)
        for (const Colour &b : cube) most = std::max(most, std::pow(flip::hyab(a, b), 0.7f));
    EXPECT_FLOAT_EQ(most, flip::largest_difference());
}

TEST(Flip, OfPlainGreenAndBlueIsOneAndOfEqualPicturesNothing)
{
    const Map<float> most = flip_map(Map<Colour>(30, 20, {0, 1, 0}), Map<Colour>(30, 20, {0, 0, 1}), ppd);
    EXPECT_NEAR(mean_of(most), 1, 1e-5);
    EXPECT_EQ(mean_of(flip_map(pattern(40, 30, 0), pattern(40, 30, 0), ppd)), 0);
}

TEST(Flip, IsTheSameEitherWayRound)
{
    const Picture a = pattern(40, 30, 0), b = noisy_pattern(40, 30);
    EXPECT_EQ(flip_map(a, b, ppd).values, flip_map(b, a, ppd).values);
}

TEST(Flip, AgreesWithTheFormulasEvaluatedDirectly)
{
    expect_as_directly(pattern(40, 30, 0), noisy_pattern(40, 30), ppd);
    expect_as_directly(pattern(37, 23, 0), pattern(37, 23, 1), ppd);
    expect_as_directly(pattern(33, 40, 0), inverted(pattern(33, 40, 0)), 20);
}

TEST(Flip, AgreesWhereOneLineIsMissing)
{
    const Picture plain = filled(50, 30, 60);
    Picture line = plain;
    for (int y = 0; y < 30; ++y)
        for (size_t c = 0; c < 3; ++c) line.rgb[3 * (static_cast<size_t>(y) * 50 + 25) + c] = 230;
    expect_as_directly(plain, line, ppd);
    const Map<float> map = flip_map(plain, line, ppd);
    EXPECT_GT(map.at(25, 15), 0.6f);  // seen as an edge too
    EXPECT_LT(map.at(2, 15), 0.01f);
}

}  // namespace
}  // namespace parity
