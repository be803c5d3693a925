// LDR-FLIP: how visible the difference is when two pictures alternate in one place (Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom, Fairchild: FLIP: A Difference Evaluator for Alternating Images, 2020). Written
// from the paper.
#pragma once

#include "samples/parity/flip_colours.h"
#include "samples/parity/map.h"

namespace parity
{

// A screen 0.7 m wide with 3840 pixels from 0.7 m, the paper's default: 67.02.
double pixels_per_degree(double distance_m = 0.7, double width_m = 0.7, double width_px = 3840);

// Each pixel's difference in [0, 1]. Both pictures of one size.
Map<float> flip_map(const Picture &reference, const Picture &result, double pixels_per_degree);
Map<float> flip_map(const Map<flip::Colour> &linear_reference, const Map<flip::Colour> &linear_result,
                    double pixels_per_degree);

double mean_of(const Map<float> &map);

}  // namespace parity
