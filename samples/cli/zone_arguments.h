// The options that give a character zones: painted by hand in a picture, or proposed from the texture's colours.
#pragma once

#include <claque/zones.h>

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

// A zone map and what it points to.
struct ZoneMap {
    std::vector<uint16_t> texels;
    std::vector<std::string> names;
    std::vector<clq_zone_map_zone> zones;
    clq_zone_map_def def = clq_zone_map_def_init();
    const clq_zone_map_def *given() const { return zones.empty() ? nullptr : &def; }
};

// Applies the arguments, reports the resulting zones on standard error and returns the map. Throws Failure.
ZoneMap give_zones(scenes::Library &library, clq_asset *asset, const ZoneArguments &arguments);

}  // namespace cli
