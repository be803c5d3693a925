// How often people are really animated, and what frames cost.
#pragma once

#include "samples/cli/scene_arguments.h"

namespace cli
{

// One second of updates at 50 Hz, which is the fastest rung, and a few pictures: the rates that are really reached and
// what a frame costs once caches are warm.
Json measured_rates(scenes::SceneRenderer &scene_renderer, double from_s);

}  // namespace cli
