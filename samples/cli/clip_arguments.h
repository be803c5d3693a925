// The options that add clips to a character: from files, bound by joint name or by a map.
#pragma once

#include "samples/scenes/library.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace cli
{

struct ClipArguments {
    std::vector<std::string> files;
    uint32_t vary = 0;   // so many clips of a built-in person in all; 0: its own
    std::string map;     // file
    std::string travel;  // empty: as the map says
    double unit_m = 0, start_s = -1, end_s = -1, close_s = -1, rate_hz = 0;  // 0 and negative: as the map says
};

void add_clip_options(CLI::App &command, ClipArguments &arguments);

// Adds what the arguments ask for. Returns the number of the first clip to show: the first of those that were added, or
// 0. Throws Failure.
uint32_t add_clips(scenes::Library &library, clq_asset *asset, const ClipArguments &arguments);

}  // namespace cli
