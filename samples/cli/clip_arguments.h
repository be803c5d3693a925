// The options that add clips to a character: from files, bound by joint name or by a map.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "samples/scenes/library.h"

namespace cli
{

struct ClipArguments {
    std::vector<std::string> files;
    uint32_t vary = 0;   // total number of clips of a built-in person; 0: its own clips
    std::string map;     // file
    std::string travel;  // empty: as the map says
    double unit_m = 0, start_s = -1, end_s = -1, close_s = -1, rate_hz = 0;  // 0 and negative: as the map says
};

// --clips, which is returned, and --map.
CLI::Option *add_clip_files(CLI::App &command, ClipArguments &arguments);
// These and all others.
void add_clip_options(CLI::App &command, ClipArguments &arguments);

// Adds the clips that the arguments name. Returns the index of the first clip to show: the first added one, or 0.
// Throws Failure.
uint32_t add_clips(scenes::Library &library, clq_asset *asset, const ClipArguments &arguments);

}  // namespace cli
