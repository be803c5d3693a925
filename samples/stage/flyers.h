// What flies over the people of a run: an actor each, on a root path.
#pragma once

#include <array>
#include <vector>

#include "samples/scenes/library.h"
#include "samples/scenes/scenario/staging.h"

namespace staged
{

class Flyers
{
public:
    // Throws Failure with the place in the scenario.
    Flyers(scenes::Library &library, clq_crowd *crowd, const scenes::Staging &stage);

    const std::vector<clq_template *> &templates() const { return templates_; }

private:
    std::vector<clq_template *> templates_;
};

// The time of one lap, and where a flyer is: on the curve that claque's flights take.
double lap_s(const scenes::ScenarioFlyer &flyer);
std::array<double, 3> place_in_flight(const scenes::ScenarioFlyer &flyer, double time_s);

}  // namespace staged
