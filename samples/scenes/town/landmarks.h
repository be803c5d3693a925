// The unique buildings of the town: a church and a town hall on the square, a fountain, market stalls, a bridge over
// the stream.
#pragma once

#include "samples/scenes/town/pieces.h"
#include "samples/scenes/town/site.h"
#include "samples/scenes/town/sun_shadows.h"
#include "samples/scenes/town/terrain.h"

namespace scenes::town
{

// Their positions on the square, in plan coordinates.
struct SquarePlan {
    double church_u, church_v, hall_u, hall_v, fountain_u, fountain_v;
};
SquarePlan square_plan(const Plan &plan);

void build_fountain(Pieces &pieces, SunShadows &shadows, const Terrain &terrain, Point at);
void build_stall(Pieces &pieces, SunShadows &shadows, const Terrain &terrain, const Site &site, uint64_t seed,
                 uint64_t who);
void build_bridge(Pieces &pieces, const Plan &plan, const Terrain &terrain);
// Builds all of them.
void build_landmarks(Pieces &pieces, SunShadows &shadows, const Plan &plan, const Terrain &terrain, uint64_t seed);

}  // namespace scenes::town
