// The record of a run in what its scenario describes: the same stone, doors, light and cameras.
#pragma once

#include "samples/scenes/scenario/scenario.h"
#include "samples/scenes/walkers/replay.h"

namespace staged
{

// `scenario` has [stage]; what it says of people is not read. Doors are shown as they were in the run. Throws Failure.
std::unique_ptr<scenes::Scene> make_replayed(scenes::Library &library, const scenes::CrowdOptions &crowd_options,
                                             const scenes::Scenario &scenario,
                                             const scenes::walkers::ReplayOptions &options);

}  // namespace staged
