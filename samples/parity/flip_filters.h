// The filters of LDR-FLIP: contrast sensitivity of the eye at a distance, edges and points (Andersson et al. 2020,
// 4.1.1 and 4.2). Pictures continue beyond their rims with the values at the rims.
#pragma once

#include <array>
#include <vector>

#include "samples/parity/map.h"

namespace parity::flip
{

using Kernel = std::vector<float>;  // odd in length; the middle one is the pixel itself

// rows: along x; columns: along y.
Map<float> filtered(const Map<float> &in, const Kernel &rows, const Kernel &columns);

enum Channel : int { achromatic, red_green, blue_yellow };

// Contrast sensitivity of the eye, as a sum of Gaussians in the plane.
Map<float> seen(const Map<float> &in, Channel channel, double pixels_per_degree);

// Half as wide as a line that the eye can detect; the kernels' positive and negative weights each sum to 1.
struct FeatureKernels {
    Kernel blur, edge, point;
};
FeatureKernels feature_kernels(double pixels_per_degree);

}  // namespace parity::flip
