// Overlays that show the state of actors: bounding spheres (S0 Fig. 2), levels of detail as tints (S0 Fig. 9), the
// culling frustum (S0 Fig. 10).
#pragma once

#include <vector>

#include "samples/scenes/eye.h"
#include "samples/scenes/gl.h"

namespace scenes
{

enum class Show { nothing, spheres, levels };

// Refpoint Bspheres blue, Sklsroot Bspheres orange; faint for actors that are not visible.
void draw_spheres(const Gl &gl, const Eye &eye, clq_crowd *crowd, const std::vector<clq_actor> &actors);

// Tints each actor by the level that the last update selected: green the finest, then yellow, orange, red, violet,
// blue and grey. Throws Failure.
void tint_by_level(clq_crowd *crowd, const std::vector<clq_actor> &actors);

// The edge of a frustum of this fraction of the picture's.
void draw_frustum(const Gl &gl, float share);

}  // namespace scenes
