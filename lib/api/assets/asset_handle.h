// The struct behind clq_asset.
#pragma once

#include <claque/assets.h>

#include "lib/lod/chain.h"
#include "lib/model/model.h"

struct clq_asset {
    explicit clq_asset(claque::model::Model &&loaded) : model(std::move(loaded)) {}
    claque::model::Model model;
    std::vector<claque::lod::LevelReport> levels;  // of the last clq_asset_make_levels
};
