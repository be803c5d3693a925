// Scenarios with tracks.
#pragma once

#include "samples/scenes/scenario/scenario.h"

namespace scenes::walkers
{

// For scenes::draw_tracks_with.
std::unique_ptr<Scene> make_scenario(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario);

}  // namespace scenes::walkers
