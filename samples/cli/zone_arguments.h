// The options that give a character zones: painted by somebody in a picture, or proposed from the texture's colours.
#pragma once

#include "samples/scenes/library.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace cli
{

struct ZoneArguments {
    uint32_t image = 0;
    std::string painted;               // PNG or JPEG: each colour a zone
    uint32_t propose = 0;              // so many zones at most
    std::vector<std::string> names;    // "#eeb28c=skin" of a painted colour, "2=skin" of a proposed zone
    std::vector<std::string> reduced;  // names, or "all"
    std::string map;                   // PNG to be written: the map as it is used, to be painted on
};

void add_zone_options(CLI::App &command, ZoneArguments &arguments);

// Does what the arguments ask for, if anything, and says on standard error which zones came of it. Throws Failure.
void give_zones(scenes::Library &library, clq_asset *asset, const ZoneArguments &arguments);

}  // namespace cli
