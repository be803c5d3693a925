// Where people can walk in the town: the square and the streets round it as triangles of the ground that is drawn, and
// outlines of everything that stands on it and of the booths in which sellers stand.
#pragma once

#include "samples/scenes/town/town.h"

namespace scenes::town
{

struct Walkable {
    std::vector<double> vertices;     // x, y, z
    std::vector<uint32_t> triangles;  // counter-clockwise from above
    struct Prism {
        std::vector<double> outline;  // x and z of a convex polygon's corners, in order
        double low_m, high_m;
    };
    std::vector<Prism> obstacles;
    std::vector<Prism> booths;  // behind the tables of stalls
};

// `around_m`: of the streets, this far from the square.
Walkable walkable_square(const Town &town, double around_m);

}  // namespace scenes::town
