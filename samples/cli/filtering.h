// What --filter linear came to.
#pragma once

#include "samples/scenes/scene_renderer.h"

#include <nlohmann/json.hpp>

namespace cli
{

// For each of the scene's templates: how many triangles are filtered, and how far they are from neighbours that are not.
nlohmann::json filtering(const scenes::SceneRenderer &scene_renderer);

}  // namespace cli
