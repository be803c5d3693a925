// The covering of the ground: streets, the square, gardens, fields, a stream; each cell of the plan in its material.
#pragma once

#include "samples/scenes/town/pieces.h"
#include "samples/scenes/town/terrain.h"

namespace scenes::town
{

void cover_ground(Pieces &pieces, const Plan &plan, const Terrain &terrain, uint64_t seed);

// Woods on the plan's cells of that kind: a roof of crowns over the cell, with an edge down to the ground.
void grow_woods(Pieces &pieces, const Plan &plan, const Terrain &terrain, uint64_t seed);

}  // namespace scenes::town
