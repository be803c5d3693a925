// Which levels of detail a model has, S0 5.1 and 5.2: at every distance at which a part begins or ends or a node stops,
// one begins. What is drawn there, and what of the skeleton is left.
#pragma once

#include "lib/model/model.h"

namespace claque::meshsplit
{

struct LevelPlan {
    float distance_m = 0;         // serves from here on
    std::vector<uint8_t> active;  // one a node: whether it and all above it still go on
    std::vector<uint32_t> parts;  // of the model, ascending: what is drawn
};

constexpr size_t max_levels = 64;

// Ascending, the first at 0. Throws base::Error (ARGUMENT) where a part would be drawn on a node that has stopped, or
// where geometry ends with a node and nothing takes over; (LIMIT) where there are more than max_levels.
std::vector<LevelPlan> plan_levels(const model::Model &model);

// Hangs as a whole on one palette entry: all its vertices follow that one alone. none: it does not.
uint32_t rigid_entry(const model::Part &part);

}  // namespace claque::meshsplit
