// What `claque tracks` finds in a file of trajectories.
#pragma once

#include <string>
#include <vector>

#include "samples/charts/drawing.h"
#include "samples/scenes/walkers/people.h"

namespace cli
{

struct TracksReport {
    std::string file;
    clq_trajectories_info info = clq_trajectories_info_init();
    double median_m_s = 0, fast_m_s = 0, fastest_m_s = 0;  // over half a second; fast: 99 of 100 are slower
    double slow_share = 0;                                 // of samples below 0.1 m/s
    // As claque shows them.
    double distance_m = 0, standing_share = 0, mean_shift_m = 0, max_shift_m = 0;
    uint64_t plants = 0, bytes = 0;
    size_t vehicles = 0, riders = 0;  // among the people
    std::vector<std::string> warnings;
};

struct Tracks {
    scenes::walkers::OwnTrajectories trajectories;
    scenes::walkers::Plan plan;
    std::vector<scenes::walkers::Person> people;
};

// The paths seen from above, given ones pale, shown ones in colours, with dots where people stand. Metres of the file.
charts::Drawing plan_drawing(const Tracks &tracks, const TracksReport &report);

}  // namespace cli
