// Levels of detail in figures.
#pragma once

#include <claque/levels.h>

#include <nlohmann/json.hpp>

#include <vector>

namespace cli
{

using Levels = std::vector<clq_made_level>;

nlohmann::ordered_json json_of(const Levels &levels);
void print(const Levels &levels);

// What each level shows of each zone, the finest first.
struct ZoneShares {
    std::vector<std::string> zones;          // the last: no zone
    std::vector<std::vector<float>> shares;  // [levels][zones]
};
ZoneShares zone_shares(const clq_asset *asset, const Levels &levels);
void print(const Levels &levels, const ZoneShares &shares);

// The same character by claque and by a quadric alone, with what each took in seconds, measuring included.
struct LevelsBeside {
    Levels ours, plain;
    double ours_s = 0, plain_s = 0;
};
void print(const LevelsBeside &beside);
nlohmann::ordered_json json_of(const LevelsBeside &beside);

}  // namespace cli
