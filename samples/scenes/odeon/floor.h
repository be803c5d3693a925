// Where people walk in a theatre: the orchestra and the ways to it round the stage house, the stairs, the walkways, and
// behind the backs of each row the strip on which the feet of the next row stand. All of it lies on the drawn stone;
// stairs are ramps through the middles of their treads.
#pragma once

#include <array>

#include "samples/scenes/odeon/theatre.h"

namespace scenes
{

struct Floor {
    std::vector<double> vertices;     // xyz
    std::vector<uint32_t> triangles;  // counter-clockwise from above
    // The strips before seats, in parts: only people of a row walk there.
    struct Strip {
        std::vector<double> outline;  // x and z of a convex polygon that has no other ground between its heights
        double low_m, high_m;
        size_t row;
    };
    std::vector<Strip> strips;
};

// The floor leaves room for bodies: the middle of a person may come so near to its edges. Cells have to be half of
// that, steps are up to 0.3 m high and up to 45 degrees steep.
constexpr double floor_radius_m = 0.08;

Floor floor_of(const Theatre &theatre);

// The height of the stone on which one stands at a distance from the axis in the middle of a gangway, tread by tread.
struct Tread {
    double from_m, to_m, y;
};
std::vector<Tread> treads_of(const Theatre &theatre, const Gangway &gangway);

// The ramp over the treads of a gangway.
double ramp_y(const std::vector<Tread> &treads, double radius_m);

// Behind the stage house, out of sight of the seats: places where people come from and go to.
std::vector<std::array<double, 3>> entrances_of(const Theatre &theatre);

}  // namespace scenes
