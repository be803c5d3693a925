// The law that `claque bench readers` judges by: ten times the elements take at most so many times the time.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>

#include <nlohmann/json.hpp>

#include "samples/cli/reader_files.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace readers
{

// n log n, with room for what does not grow evenly.
constexpr double most_ratio = 16;

// How strictly readers are judged.
struct Law {
    double most_ratio = readers::most_ratio;
    // Shorter times are not judged: they are of the clock's resolution and of caches that are still cold.
    double least_ms = 20;
};

inline double ratio(double few_ms, double many_ms, const Law &law = {})
{
    return many_ms < law.least_ms ? 0 : many_ms / std::max(few_ms, 1.0);
}

inline bool is_lawful(const Reading &few, const Reading &many, const Law &law = {})
{
    return std::max(ratio(few.load_ms, many.load_ms, law), ratio(few.build_ms, many.build_ms, law)) <= law.most_ratio;
}

inline std::string ratios_of(const nlohmann::ordered_json &run)
{
    char text[100];
    std::snprintf(text, sizeof text, " (%.3g, at most %g)",
                  std::max(run.at("load_ratio").get<double>(), run.at("build_ratio").get<double>()),
                  run.at("most_ratio").get<double>());
    return text;
}

// Throws scenes::Failure that names the rows that are not lawful, with their ratios.
inline void expect_lawful(const nlohmann::ordered_json &report)
{
    std::string names;
    for (const nlohmann::ordered_json &run : report.at("runs"))
        if (!run.at("lawful").get<bool>())
            names += (names.empty() ? "" : ", ") + run.at("format").get<std::string>() + " " +
                     run.at("element").get<std::string>() + ratios_of(run);
    if (!names.empty()) throw scenes::Failure("ten times the elements take too many times the time: " + names);
}

}  // namespace readers
}  // namespace cli
