// Trees: in gardens, in the park, on the square, along roads and the stream, and here and there between fields.
#pragma once

#include "samples/scenes/town/houses.h"
#include "samples/scenes/town/sun_shadows.h"

namespace scenes::town
{

struct Tree {
    enum class Kind : uint8_t { broad, poplar, fir } kind;
    Point at;
    double height_m, radius_m;
};

// None stands in a house, on a street or in the water.
std::vector<Tree> place_trees(const Plan &plan, const std::vector<House> &houses, uint64_t seed);
void plant_hedges(Pieces &pieces, const Plan &plan, const Terrain &terrain, const std::vector<House> &houses,
                  uint64_t seed);
void grow_tree(Pieces &pieces, SunShadows &shadows, const Tree &tree, const Terrain &terrain, uint64_t seed);

}  // namespace scenes::town
