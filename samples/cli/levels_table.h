// Levels of detail in numbers.
#pragma once

#include <claque/levels.h>

#include <vector>

#include <nlohmann/json.hpp>

namespace cli
{

using Levels = std::vector<clq_level_report>;

nlohmann::ordered_json json_of(const Levels &levels);
void print(const Levels &levels);

// The area fraction of each zone in each level, from the finest on.
struct ZoneAreas {
    std::vector<std::string> zones;                  // the last: no zone
    std::vector<std::vector<float>> area_fractions;  // [levels][zones]
};
ZoneAreas zone_areas(const clq_asset *asset, const Levels &levels);
void print(const Levels &levels, const ZoneAreas &area_fractions);

// The levels of one character by claque and by OpenMesh's quadric alone, with the seconds that each took, measuring
// included.
struct LevelsComparison {
    Levels ours, quadric_only;
    double ours_s = 0, quadric_only_s = 0;
};
void print(const LevelsComparison &comparison);
nlohmann::ordered_json json_of(const LevelsComparison &comparison);

}  // namespace cli
