// The level ground of a studio, which fades into its backdrop.
#pragma once

#include "samples/scenes/geometry.h"

namespace scenes
{

// Lays it round (x, y, z), `half_m` each way. At `fade_m` from there it has the backdrop's colour.
void lay_studio_ground(Geometry &ground, double x, double y, double z, double half_m, double fade_m);

}  // namespace scenes
