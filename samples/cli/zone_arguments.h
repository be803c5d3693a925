// The options that give a character zones: painted by hand in a picture, or proposed from the texture's colours.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "samples/scenes/library.h"

namespace cli
{

struct ZoneArguments {
    uint32_t image = 0;
    std::string painted;               // PNG or JPEG: each colour a zone
    uint32_t propose = 0;              // maximum number of zones
    std::vector<std::string> names;    // "#eeb28c=skin" of a painted colour, "2=skin" of a proposed zone
    std::vector<std::string> reduced;  // names, or "all"
    std::string map;                   // PNG to write: the current map, to be painted on
};

void add_zone_options(CLI::App &command, ZoneArguments &arguments);

// Applies the arguments and reports the resulting zones on standard error. Throws Failure.
void give_zones(scenes::Library &library, clq_asset *asset, const ZoneArguments &arguments);

}  // namespace cli
