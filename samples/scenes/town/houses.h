// The houses of the town: their positions and their construction.
#pragma once

#include "samples/scenes/town/pieces.h"
#include "samples/scenes/town/site.h"
#include "samples/scenes/town/terrain.h"

namespace scenes::town
{

struct House {
    enum class Roof : uint8_t { gable, gable_to_street, hip } roof;
    enum class Style : uint8_t { plaster, timber, shop, barn } style;
    Point at, out;                   // its centre, and the direction of its front
    double width_m, depth_m, pitch;  // pitch: rise of the roof over its run
    int storeys;
    uint64_t number;
    Rgb walls, tiles;
    bool chimney;

    static constexpr double storey_m = 2.85, plinth_m = 0.3, eaves_m = 0.45;
    Site site() const { return Site(at, out); }
    double eaves_height() const { return plinth_m + storeys * storey_m; }
    double ridge_height() const;
};

// Along the streets of every block except the square and the park, and a few farms. The same for equal arguments.
std::vector<House> place_houses(const Plan &plan, uint64_t seed);

// The floor: the ground at the highest corner.
double floor_of(const House &house, const Terrain &terrain);

void build_house(Pieces &pieces, const House &house, const Terrain &terrain, uint64_t seed);

}  // namespace scenes::town
