// The folder of collected characters, which not every checkout has.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "lib/asset/file.h"
#include "maker.h"

namespace claque::testing
{

inline std::string assets_folder() { return CLAQUE_ASSETS_DIR; }

inline bool has_assets() { return std::filesystem::exists(assets_folder() + "/inventory.json"); }

#define CLAQUE_NEEDS_ASSETS() \
    if (!claque::testing::has_assets()) GTEST_SKIP() << "no characters in " << CLAQUE_ASSETS_DIR

inline Bytes read_asset(const std::string &name) { return asset::read_file(assets_folder() + "/" + name, 1u << 30); }

inline asset::LoadOptions options_for(const std::string &name)
{
    asset::LoadOptions options;
    options.base_folder = std::filesystem::path(assets_folder() + "/" + name).parent_path().string();
    return options;
}

}  // namespace claque::testing
