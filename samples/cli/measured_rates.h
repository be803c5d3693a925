// How often people are animated, and what frames cost.
#pragma once

#include "samples/cli/scene_arguments.h"

namespace cli
{

// Measures one second of updates at 50 Hz, the fastest rate step, and a few pictures: the rates that are reached, and
// what a frame costs once caches are warm.
Json measured_rates(scenes::SceneRenderer &scene_renderer, double from_s);

}  // namespace cli
