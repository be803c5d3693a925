// The stone of a theatre's stairs below a point: where feet stand that a ramp through the treads leads up and down.
#pragma once

#include "samples/scenes/odeon/floor.h"

namespace scenes
{

class StairStone
{
public:
    explicit StairStone(const Theatre &theatre);

    // NaN: no stairs are within a metre over or below the point.
    double height_m(const double point[3]) const;

private:
    struct Flight {
        double at_deg, half_width_m;
        std::vector<Tread> treads;
    };
    std::vector<Flight> flights_;
};

}  // namespace scenes
