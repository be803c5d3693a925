// The OpenGL state that a scene has set for the crowd: lights and fog, as in capture.json (docs/parity.md).
#pragma once

#include "samples/contexts/offscreen.h"
#include "samples/parity/write/drawn_actors.h"

namespace parity
{

// The context must be current. All throw scenes::Failure if it lacks a function.
Json lighting_of(const contexts::Offscreen &context);
Json fog_of(const contexts::Offscreen &context);  // null if there is none
// In each direction, to which the rasteriser rounds the position of a vertex in the picture.
int subpixel_bits(const contexts::Offscreen &context);

}  // namespace parity
