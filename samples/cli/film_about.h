// What the frames of a film depend on.
#pragma once

#include "samples/cli/render_work.h"

namespace cli
{

// scene_about() with what only films have. Files are read to the end, for their SHA-256.
Json film_scene(const RenderArguments &arguments, const scenes::SceneOptions &options);
// With provenance(). `gl`: what the context calls itself.
Json film_about(const RenderArguments &arguments, const scenes::SceneOptions &options, const std::string &gl);

}  // namespace cli
