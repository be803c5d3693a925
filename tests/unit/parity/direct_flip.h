// LDR-FLIP a second time, slowly: the paper's formulas unchanged, in double precision, with whole kernels in the plane
// and the constants that its authors publish. It shares nothing with samples/parity.
#pragma once

#include <array>
#include <vector>

namespace parity_test
{

using Rgb = std::array<double, 3>;

// linear: [width * height]. One value per pixel.
std::vector<double> direct_flip(const std::vector<Rgb> &reference, const std::vector<Rgb> &result, int width,
                                int height, double pixels_per_degree);

Rgb linear_of_srgb(int r, int g, int b);

}  // namespace parity_test
