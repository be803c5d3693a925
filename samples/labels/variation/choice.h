// What was chosen for one sample.
#pragma once

#include "samples/labels/frame_json.h"
#include "samples/labels/variation/rules.h"

namespace labels
{

struct Choice {
    uint64_t seed = 0;    // of all choices
    uint32_t sample = 0;  // its number
    uint32_t scene_seed = 0;
    double time_s = 0;
    std::optional<uint32_t> count;
    std::vector<std::pair<std::string, double>> classes;
    std::string colours;  // a file; empty: the scene's own
    std::optional<double> hour, sun, sky, visibility_m, read_noise, shot_noise;
    std::optional<int> jpeg_quality;
};

// The camera is chosen later, among the people that are there (standpoint.h). time_s: where there is no rule for it.
Choice choose(const Rules &rules, uint64_t seed, uint32_t sample, double time_s);

Json choice_json(const Choice &choice);

}  // namespace labels
