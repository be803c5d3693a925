// The struct behind clq_asset.
#pragma once

#include <claque/assets.h>

#include "lib/asset/near_colours.h"
#include "lib/lod/chain.h"
#include "lib/model/model.h"

struct clq_asset {
    explicit clq_asset(claque::model::Model &&loaded) : model(std::move(loaded)) {}
    claque::model::Model model;
    bool placed = false;                                            // node 0 is no node of its file (placement.h)
    claque::asset::Colours colours = claque::asset::Colours::wild;  // of zones that get no range
    std::vector<claque::lod::LevelReport> levels;                   // of the last clq_asset_make_levels
};
