// Levels of detail in figures.
#pragma once

#include <claque/levels.h>

#include <nlohmann/json.hpp>

#include <vector>

namespace cli
{

using Levels = std::vector<clq_level_report>;

nlohmann::ordered_json json_of(const Levels &levels);
void print(const Levels &levels);

// What each level shows of each zone, the finest first.
struct ZoneAreas {
    std::vector<std::string> zones;                  // the last: no zone
    std::vector<std::vector<float>> area_fractions;  // [levels][zones]
};
ZoneAreas zone_areas(const clq_asset *asset, const Levels &levels);
void print(const Levels &levels, const ZoneAreas &area_fractions);

// The same character by claque and by a quadric alone, with what each took in seconds, measuring included.
struct LevelsComparison {
    Levels ours, quadric_only;
    double ours_s = 0, quadric_only_s = 0;
};
void print(const LevelsComparison &comparison);
nlohmann::ordered_json json_of(const LevelsComparison &comparison);

}  // namespace cli
