// The folder of collected characters, which not every checkout has, and the one of written characters, which all have.
#pragma once

#include <algorithm>
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

inline bool has_any(const std::string &text, const std::vector<std::string> &words)
{
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string &word) { return text.find(word) != std::string::npos; });
}

// One line of three words or more, which ends with a word, a number or a bracket.
inline bool is_sentence(const std::string &text)
{
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 32; };
    return std::count(text.begin(), text.end(), ' ') >= 2 && text.size() < 500 &&
           std::none_of(text.begin(), text.end(), is_control) &&
           std::string(" :,;").find(text.back()) == std::string::npos;
}

}  // namespace claque::testing
