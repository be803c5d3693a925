// Writes parity folders (docs/parity.md) of a scene: for another renderer, or with the result of the CPU path.
#pragma once

#include <string>

#include "samples/scenes/scene_renderer.h"

namespace parity
{

struct CaptureTime {
    std::string scene;  // in words
    double time_s = 0;
    int width = 0, height = 0;
};

// Both update the scene and draw in its context, which must have 8 bits a channel. Files of an older capture are
// removed first; capture.json is written last. Return the number of drawn individuals. Throw scenes::Failure.
size_t write_scene(scenes::SceneRenderer &scene_renderer, const CaptureTime &capture_time, const std::string &folder);
size_t write_result(scenes::SceneRenderer &scene_renderer, const CaptureTime &capture_time, const std::string &folder);

// The crowd alone on black, in the scene's lights and fog.
clq_draw_stats draw_alone(scenes::SceneRenderer &scene_renderer);

}  // namespace parity
