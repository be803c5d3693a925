// Positions of the actors of `hundred_actors` for which S0's Table 2 holds exactly at any time. Positions are picked
// at random and accepted if the spheres that the library reports satisfy the class's condition at every point of the
// dragon's path.
#pragma once

#include <claque/crowd.h>

#include <vector>

#include "samples/scenes/hundred/frustum.h"

namespace scenes::hundred
{

// The rows of Table 2. C3.1 is split in two: Internal Bspheres all within, or all outside.
enum class Row : uint32_t { a, b, c1, c2, c31_within, c31_outside, c32 };

// The path of the Skeleton Root round the Reference Point.
enum class PathKind : uint32_t {
    round,   // a circle about it
    aside,   // a circle that lies entirely to one side of it, so that the Refpoint Bsphere is far larger
    to_fro,  // a little ahead and back
    count
};

constexpr double circle_m = 4.5, aside_m = 12, to_fro_m = 0.8;

// The library's spheres of the dragon: its Sklsroot Bsphere, and the Refpoint Bsphere for each path.
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

// Throws Failure if no position is found; no seed should cause that.
std::vector<Spot> find_spots(const Spheres &spheres, uint64_t seed);

}  // namespace scenes::hundred
