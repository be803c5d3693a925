// The OpenGL state that a scene has set for the crowd: lights and fog, as in capture.json (docs/parity.md).
#pragma once

#include "samples/contexts/offscreen.h"
#include "samples/parity/write/drawn_actors.h"

namespace parity
{

// The context must be current. Both throw scenes::Failure for state that a parity folder cannot describe.
Json lighting_of(const contexts::Offscreen &context);
Json fog_of(const contexts::Offscreen &context);  // null if there is none

}  // namespace parity
