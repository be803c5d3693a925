// The linen and ropes of the velarium as triangles: the cloth has a lit side and one that the sun shines through.
#pragma once

#include "samples/scenes/amphitheatre/exposure.h"

namespace scenes::amphitheatre
{

Geometry linen(const Plan &plan, const Velarium &velarium, const Daylight &light, uint64_t seed);
// To be blended.
Geometry ropes(const Plan &plan, const Velarium &velarium);

}  // namespace scenes::amphitheatre
