// The lake over which the dragons of `hundred_actors` fly, and a plan on it that shows an outside camera which dragons
// are in view.
#pragma once

#include "samples/scenes/geometry.h"
#include "samples/scenes/hundred/spots.h"

namespace scenes::hundred
{

constexpr Rgb lake_haze = {0.80f, 0.85f, 0.87f};

// Water to the horizon, and rocks with pines out of reach of the dragons.
void fill_lake(Geometry &water, Geometry &rocks, const std::vector<Spot> &spots, const Spheres &spheres, uint64_t seed);

// Draws the rings of the Refpoint Bspheres in the colours of Table 2's rows, and the part of the lake under the
// frustum.
void draw_plan(Geometry &plan, const std::vector<Spot> &spots, const Spheres &spheres);

}  // namespace scenes::hundred
