// Pictures of what is known of actors, over the scene: bounding spheres (S0 Fig. 2), levels of detail as tints (S0 Fig. 9),
// the pyramid that culls (S0 Fig. 10).
#pragma once

#include "samples/scenes/eye.h"
#include "samples/scenes/gl.h"

#include <vector>

namespace scenes
{

enum class Show { nothing, spheres, levels };

// Refpoint Bspheres blue, Sklsroot Bspheres orange; of who is not seen, faint.
void draw_spheres(const Gl &gl, const Eye &eye, clq_crowd *crowd, const std::vector<clq_actor> &actors);

// Everybody in the colour of the level that the last update chose: green the finest, then yellow, orange, red, violet, blue
// and grey. Throws Failure.
void tint_by_level(clq_crowd *crowd, const std::vector<clq_actor> &actors);

// The edge of what a pyramid of this share of the picture's meets.
void draw_frustum(const Gl &gl, float share);

}  // namespace scenes
