// What the frames of a film depend on.
#pragma once

#include "samples/cli/render_work.h"

namespace cli
{

// Everything but the time: the options, the SHA-256 of the files that they name, and provenance(). What changes no
// pixel, as strategy, cache and threads, is left out. `gl`: what the context calls itself.
Json film_about(const RenderArguments &arguments, const scenes::SceneOptions &options, const std::string &gl);

}  // namespace cli
