// What the pixels of a scene depend on, as its options say it.
#pragma once

#include "samples/cli/scene_arguments.h"

namespace cli
{

// A file's name and SHA-256. What is no file, as the name of a built-in character, stays as it is.
Json file_about(const std::string &path);
// The same of a record, of which a film reads a part: the size, and the SHA-256 of the first and the last MiB, where
// its first state, its last calls and its index are.
Json record_about(const std::string &path);

// Everything but the time: the options and the SHA-256 of the files that they name. What changes no pixel, as strategy,
// cache and threads, is left out.
Json scene_about(const SceneArguments &arguments, const scenes::SceneOptions &options);

// The first member in which two such objects differ: "/scene/hour is 8 there and 9 here".
std::string difference(const Json &there, const Json &here);

}  // namespace cli
