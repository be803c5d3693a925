// The effect of --filter linear.
#pragma once

#include <nlohmann/json.hpp>

#include "samples/scenes/scene_renderer.h"

namespace cli
{

// For each template of the scene: how many triangles are filtered, and their distance from unfiltered neighbours.
nlohmann::json filtering(const scenes::SceneRenderer &scene_renderer);

}  // namespace cli
