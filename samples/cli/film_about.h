// What the frames of a film depend on.
#pragma once

#include "samples/cli/render_work.h"

namespace cli
{

// scene_about() with what only films have, and provenance(). `gl`: what the context calls itself.
Json film_about(const RenderArguments &arguments, const scenes::SceneOptions &options, const std::string &gl);

}  // namespace cli
