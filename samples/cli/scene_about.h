// What the pixels of a scene depend on, as its options say it.
#pragma once

#include "samples/cli/scene_arguments.h"

namespace cli
{

// A file's name and SHA-256. What is no file, as the name of a built-in character, stays as it is.
Json file_about(const std::string &path);

// Everything but the time: the options and the SHA-256 of the files that they name. What changes no pixel, as strategy,
// cache and threads, is left out.
Json scene_about(const SceneArguments &arguments, const scenes::SceneOptions &options);

}  // namespace cli
