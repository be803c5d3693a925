// Daylight on the fixed-function pipeline: a sun, scattered light of the sky, and light reflected by the ground.
#pragma once

#include <claque/shadow.h>

#include "samples/scenes/eye.h"
#include "samples/scenes/geometry.h"

namespace scenes
{

struct Daylight {
    Vec3 to_sun = {-0.50f, 0.66f, 0.56f};
    Rgb sun = {0.70f, 0.65f, 0.55f};
    Rgb sky = {0.38f, 0.40f, 0.44f};     // from everywhere
    Rgb bounce = {0.13f, 0.11f, 0.09f};  // from the side away from the sun
};

// The settings of claque's shadows for this light (claque/shadow.h).
clq_shadow_def shadows_in(const Daylight &light);

// Does for a vertex what GL does with these lights and a texture of one colour: its colour becomes that of the picture.
void shine(const Daylight &light, SceneryVertex &vertex, Rgb texel);

// Switches lighting on with lights 0 and 1, and the depth test; lights 2 and 3, textures, fog and the culling of faces
// off. Sets the state that claque inherits; afterwards the model-view matrix is the eye's view. Materials follow
// colours.
void set_lights(const Gl &gl, const Daylight &light, const Eye &eye);

}  // namespace scenes
