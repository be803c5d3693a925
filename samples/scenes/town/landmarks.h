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

// On ordinary days there are eight stalls on the square; on market days, as many rows as there is room for.
enum class Trade : uint8_t { ordinary, market_day };
// Behind the front of a stall stands its seller, at out = -0.45; before its table, from out = 1.1 on, those who buy.
std::vector<Site> stall_sites(const Plan &plan, Trade trade);

// The ground plan of something that nothing walks through.
struct Footprint {
    Site site;
    double along0, along1, out0, out1;
};
// Of everything that build_landmarks builds on the square.
std::vector<Footprint> landmark_footprints(const Plan &plan, Trade trade);

// Of what lies behind the table of each stall, between its posts: people can walk there, but sellers alone do.
std::vector<Footprint> stall_booths(const Plan &plan, Trade trade);

void build_fountain(Pieces &pieces, SunShadows &shadows, const Terrain &terrain, Point at);
void build_stall(Pieces &pieces, SunShadows &shadows, const Terrain &terrain, const Site &site, uint64_t seed,
                 uint64_t number);
void build_bridge(Pieces &pieces, const Plan &plan, const Terrain &terrain);
// Builds all of them.
void build_landmarks(Pieces &pieces, SunShadows &shadows, const Plan &plan, const Terrain &terrain, uint64_t seed,
                     Trade trade);

}  // namespace scenes::town
