// The ground: the sand of the arena, the paving round the building, and the town beyond.
#pragma once

#include "samples/scenes/amphitheatre/masonry.h"

namespace scenes::amphitheatre
{

constexpr double sand_metres = 9;

Geometry arena_floor(const Plan &plan, const Exposure &exposure);
Geometry paving(const Plan &plan, const Exposure &exposure);
// Houses of brick and plaster with roofs of tiles, outside the paving.
Geometry houses(const Plan &plan, const Daylight &light, uint64_t seed);

}  // namespace scenes::amphitheatre
