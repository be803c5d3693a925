// Characters of ../shared/assets, where they are, and the written ones.
#pragma once

#include <filesystem>

#include "lib/asset/file.h"
#include "lib/asset/gltf.h"
#include "tests/support/written_characters.h"

namespace claque::test
{

inline bool collected_are_there()
{
    return std::filesystem::exists(std::string(CLAQUE_ASSETS_DIR) + "/inventory.json");
}

inline model::Model loaded(const std::string &name)
{
    const std::string path = written::path_of(name, CLAQUE_ASSETS_DIR);
    asset::LoadOptions options;
    options.base_folder = std::filesystem::path(path).parent_path().string();
    const std::vector<uint8_t> bytes = asset::read_file(path, 1u << 30);
    return asset::load_gltf(bytes.data(), bytes.size(), options);
}

}  // namespace claque::test
