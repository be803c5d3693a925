// A flat wall of screens before one eye point: columns side by side, each with a frustum of its own that begins where
// its neighbour's ends. This is all a simulator with several projectors needs.
#pragma once

#include <claque/view.h>

namespace multichannel
{

class Wall
{
public:
    static constexpr int columns = 3;

    // The eye looks straight at the wall. The arguments are tangents of half the angles of the whole wall.
    Wall(double tan_half_width, double tan_half_height, double z_near, double z_far);

    // The camera of `count` adjacent columns as one picture, [first, first + count) of [0, columns).
    clq_camera camera(const double (&eye)[3], const double (&target)[3], int first, int count) const;

private:
    double tan_half_width_, tan_half_height_, near_, far_;
};

}  // namespace multichannel
