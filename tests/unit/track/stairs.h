// Stairs as a host has them: treads for the feet, and the ramp through their middles for the path.
#pragma once

#include "tests/unit/track/made_tracks.h"

namespace claque::test
{

// Treads from first_m to last_m along z, level before and behind.
struct Stairs {
    static constexpr double first_m = 3, last_m = 9;

    double run_m = 0.39, rise_m = 0.215;

    double tread(double z) const;
    double ramp(double z) const;
};

// A person that goes up, or down, at a speed over the ground.
std::vector<track::Point> climb(const Stairs &stairs, double speed, bool down);

// The ground of a track's settings; the stairs outlive the track's making.
track::BuildSettings settings_for(Stairs &stairs);

}  // namespace claque::test
