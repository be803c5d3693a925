// Reads trajectories from texts and files, and says how that ended.
#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "lib/asset/file.h"
#include "lib/base/error.h"
#include "tests/support/collected_file.h"
#include "writers.h"

namespace claque::testing
{

inline std::string tracks_folder() { return CLAQUE_ASSETS_DIR "/tracks/"; }

#define CLAQUE_NEEDS_TRACKS() CLAQUE_NEEDS_FILE(tracks_folder() + "README.md")

inline Bytes bytes_of_text(const std::string &text) { return Bytes(text.begin(), text.end()); }

// The library that a file needs and this build lacks; "": none.
inline std::string missing_library(const std::string &name)
{
    const std::string ending = name.substr(name.find_last_of('.') + 1);
#ifndef CLAQUE_HAS_SQLITE3
    if (ending == "sqlite") return "libsqlite3";
#endif
#ifndef CLAQUE_HAS_EXPAT
    if (ending == "xml") return "libexpat";
#endif
#ifndef CLAQUE_HAS_Z
    if (ending == "gz") return "zlib";
#endif
    return "";
}

#define CLAQUE_NEEDS_LIBRARY_OF(name)                    \
    if (!claque::testing::missing_library(name).empty()) \
    GTEST_SKIP() << (name) << " needs " << claque::testing::missing_library(name) << ", which this build lacks"

inline asset::Trajectories read_bytes(const Bytes &bytes, const asset::TrajectoryOptions &options = {},
                                      const std::string &name = "")
{
    asset::TrajectoryInput input;
    input.bytes = bytes.data(), input.size = bytes.size();
    input.name = name;
    return asset::read_trajectories(input, options);
}

inline asset::Trajectories read_text(const std::string &text, const asset::TrajectoryOptions &options = {})
{
    return read_bytes(bytes_of_text(text), options);
}

inline asset::Trajectories read_track_file(const std::string &name, const asset::TrajectoryOptions &options = {})
{
    const std::string path = tracks_folder() + name;
    const Bytes bytes = asset::read_file(path, 1u << 30);
    asset::TrajectoryInput input;
    input.bytes = bytes.data(), input.size = bytes.size();
    input.name = path;
    const std::string matrix = path.substr(0, path.find_last_of('/')) + "/H.txt";
    if (std::filesystem::exists(matrix)) {
        const Bytes text = asset::read_file(matrix, 4096);
        input.beside = [text] { return std::string(text.begin(), text.end()); };
    }
    return asset::read_trajectories(input, options);
}

struct Refusal {
    int status = 0;
    std::string text = "read";
};
inline Refusal refusal_of(const Bytes &bytes, const asset::TrajectoryOptions &options = {},
                          const std::string &name = "")
{
    try {
        read_bytes(bytes, options, name);
        return {};
    } catch (const base::Error &error) {
        return {error.status(), error.what()};
    }
}

// The refusal of a text has this status and holds this sentence.
inline void expect_refused(const std::string &text, int status, const std::string &sentence,
                           const asset::TrajectoryOptions &options = {})
{
    const Refusal refusal = refusal_of(bytes_of_text(text), options);
    EXPECT_EQ(refusal.status, status) << refusal.text;
    EXPECT_NE(refusal.text.find(sentence), std::string::npos) << "'" << refusal.text << "' lacks '" << sentence << "'";
}

inline asset::TrajectoryOptions of_table(const std::string &columns, double rate_hz = 0, double unit_m = 1)
{
    asset::TrajectoryOptions options;
    options.columns = columns;
    options.rate_hz = rate_hz, options.metres_per_unit = unit_m;
    return options;
}

// Whether one warning holds all of these.
inline bool warns(const asset::Trajectories &read, const std::vector<std::string> &parts)
{
    for (const std::string &warning : read.warnings) {
        bool all = true;
        for (const std::string &part : parts) all = all && warning.find(part) != std::string::npos;
        if (all) return true;
    }
    return false;
}

inline std::string all_warnings(const asset::Trajectories &read)
{
    std::string out;
    for (const std::string &warning : read.warnings) out += warning + "\n";
    return out;
}

}  // namespace claque::testing
