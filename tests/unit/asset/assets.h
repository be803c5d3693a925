// The folder of collected characters, which not every checkout has, and the one of written characters, which all have.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "lib/asset/file.h"
#include "maker.h"
#include "tests/support/written_characters.h"

namespace claque::testing
{

inline std::string assets_folder() { return CLAQUE_ASSETS_DIR; }

inline bool has_assets() { return std::filesystem::exists(assets_folder() + "/inventory.json"); }

#define CLAQUE_NEEDS_ASSETS() \
    if (!claque::testing::has_assets()) GTEST_SKIP() << "no characters in " << CLAQUE_ASSETS_DIR

inline std::string path_of(const std::string &name) { return written::path_of(name, assets_folder()); }

inline Bytes read_asset(const std::string &name) { return asset::read_file(path_of(name), 1u << 30); }

inline asset::LoadOptions options_for(const std::string &name)
{
    asset::LoadOptions options;
    options.base_folder = std::filesystem::path(path_of(name)).parent_path().string();
    return options;
}

}  // namespace claque::testing
