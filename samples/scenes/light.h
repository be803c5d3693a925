// Daylight on the fixed-function pipeline: a sun, what the sky scatters, and what the ground throws back.
#pragma once

#include "samples/scenes/eye.h"
#include "samples/scenes/geometry.h"

namespace scenes
{

struct Daylight {
    Vec3 to_sun = {-0.45f, 0.75f, 0.50f};
    Rgb sun = {0.66f, 0.60f, 0.49f};
    Rgb sky = {0.36f, 0.38f, 0.43f};     // from everywhere
    Rgb bounce = {0.13f, 0.11f, 0.09f};  // from the side away from the sun
};

// Switches lighting on with lights 0 and 1 and sets what claque inherits; the model-view matrix is the eye's view
// afterwards. Materials follow colours.
void shine(const Gl &gl, const Daylight &light, const Eye &eye);

}  // namespace scenes
