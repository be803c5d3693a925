// A flat wall of screens before one pair of eyes: columns side by side, each with a frustum of its own that begins where its
// neighbour's ends. What a simulator with several projectors has to know.
#pragma once

#include <claque/view.h>

namespace multichannel
{

class Wall
{
public:
    static constexpr int columns = 3;

    // The eye looks straight at the wall. Tangents of half the angles that the whole wall covers.
    Wall(double tan_half_width, double tan_half_height, double z_near, double z_far);

    // Of `count` neighbouring columns as one picture, [first, first + count) of [0, columns).
    clq_camera camera(const double (&eye)[3], const double (&target)[3], int first, int count) const;

private:
    double tan_half_width_, tan_half_height_, near_, far_;
};

}  // namespace multichannel
