// The lake over which the dragons of `hundred_actors` fly, and a plan of who is in view on it for those who look from
// outside.
#pragma once

#include "samples/scenes/geometry.h"
#include "samples/scenes/hundred/spots.h"

namespace scenes::hundred
{

constexpr Rgb lake_haze = {0.80f, 0.85f, 0.87f};

// Water to the horizon, and rocks with pines where no dragon comes.
void fill_lake(Geometry &water, Geometry &rocks, const std::vector<Spot> &spots, const Spheres &spheres, uint64_t seed);

// The rings of the Refpoint Bspheres in the colours of Table 2's rows, and the share of the lake under the pyramid.
void draw_plan(Geometry &plan, const std::vector<Spot> &spots, const Spheres &spheres);

}  // namespace scenes::hundred
