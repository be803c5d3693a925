// The ground below walkers: paving where a walkable area says so, or everywhere, and low walls round the area.
#pragma once

#include "samples/scenes/geometry.h"
#include "samples/scenes/walkers/people.h"

namespace scenes::walkers
{

struct Ground {
    explicit Ground(float texture_metres) : paving(texture_metres), walls(texture_metres) {}
    Geometry paving, walls, around;
};

// Without an area: paving round the people. Throws Failure.
void lay(Library &library, const Options &options, const Plan &plan, Ground &ground);

}  // namespace scenes::walkers
