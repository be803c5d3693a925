// A parity folder (docs/parity.md) of what a stage shows: for another renderer, or what the CPU path made of it.
#pragma once

#include "samples/scenes/scene_renderer.h"

#include <string>

namespace parity
{

struct CaptureTime {
    std::string scene;  // in words
    double time_s = 0;
    int width = 0, height = 0;
};

// Both update the stage and draw in its context, of 8 bits a channel. What was in the folder of an older capture goes first;
// capture.json comes last. Return how many individuals are drawn. Throw scenes::Failure.
size_t write_scene(scenes::SceneRenderer &scene_renderer, const CaptureTime &capture_time, const std::string &folder);
size_t write_result(scenes::SceneRenderer &scene_renderer, const CaptureTime &capture_time, const std::string &folder);

// The crowd alone on black, in the scene's lights and fog.
clq_draw_stats draw_alone(scenes::SceneRenderer &scene_renderer);

}  // namespace parity
