// What a scene has set in OpenGL for whoever is drawn next: lights and fog, as capture.json has them (docs/parity.md).
#pragma once

#include "samples/contexts/offscreen.h"
#include "samples/parity/write/drawn_actors.h"

namespace parity
{

// The context must be current. Throw scenes::Failure where something is set that another renderer could not be told of.
Json lighting_of(const contexts::Offscreen &context);
Json fog_of(const contexts::Offscreen &context);  // null where there is none

}  // namespace parity
