// The scene of a scenario with [[people]]: single individuals with roles, on level ground.
#pragma once

#include "samples/scenes/scenario/scenario.h"

namespace scenes::roles
{

// For scenes::draw_people_with.
std::unique_ptr<Scene> make_scenario(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario);

}  // namespace scenes::roles
