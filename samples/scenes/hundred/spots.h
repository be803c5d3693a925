// Who hovers where in `hundred_actors`, so that S0's Table 2 holds exactly, at any time: places are drawn by lot and taken
// where the spheres that the library reports lie as the class wants it, wherever on its way the dragon is.
#pragma once

#include "samples/scenes/hundred/frustum.h"

#include <claque/crowd.h>

#include <vector>

namespace scenes::hundred
{

// The rows of Table 2. C3.1 is two: Internal Bspheres all within, or all outside.
enum class Row : uint32_t { a, b, c1, c2, c31_within, c31_outside, c32 };

// Of the Skeleton Root round the Reference Point.
enum class PathKind : uint32_t {
    round,   // a circle about it
    aside,   // a circle all of which lies to one side of it, so that the Refpoint Bsphere is far larger
    to_fro,  // a little ahead and back
    count
};

constexpr double circle_m = 4.5, aside_m = 12, to_fro_m = 0.8;

// What the library says of the dragon: its Sklsroot Bsphere, and the Refpoint Bsphere for each way.
struct Spheres {
    Point sklsroot_centre;
    double sklsroot;
    double refpoint[static_cast<size_t>(PathKind::count)];
};

struct Spot {
    Row row;
    PathKind way;
    clq_transform place;
};

// Throws Failure where there is no room, which no seed should meet.
std::vector<Spot> find_spots(const Spheres &spheres, uint64_t seed);

}  // namespace scenes::hundred
