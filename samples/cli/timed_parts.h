// A picture drawn part by part, so that the crowd alone is timed.
#pragma once

#include "samples/cli/stopwatch.h"
#include "samples/scenes/scene_renderer.h"

namespace cli
{

// Draws a whole picture and returns the milliseconds of the crowd.
inline double timed_crowd(scenes::SceneRenderer &scene_renderer)
{
    using Part = scenes::SceneRenderer::Part;
    double ms = 0;
    scene_renderer.draw_apart([&](Part part, auto draw) {
        const Stopwatch watch;
        draw();
        if (part == Part::crowd) ms = watch.ms();
    });
    return ms;
}

}  // namespace cli
