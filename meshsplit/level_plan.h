// Plans the levels of detail of a model, S0 5.1 and 5.2. A level begins at every distance at which a part begins or
// ends or a node stops. A plan lists what is drawn and which nodes remain.
#pragma once

#include "lib/model/model.h"
#include "lib/model/template.h"

namespace claque::meshsplit
{

struct LevelPlan {
    float distance_m = 0;         // the level is used from this distance on
    std::vector<uint8_t> active;  // [nodes] whether the node and all its ancestors are active
    std::vector<uint32_t> parts;  // drawn parts of the model, ascending
};

using model::max_levels;

// Returns plans in ascending order, the first at 0. Throws base::Error (ARGUMENT) if a part would be drawn on a stopped
// node, or if geometry ends with a node and nothing replaces it; (LIMIT) if there are more than max_levels.
std::vector<LevelPlan> plan_levels(const model::Model &model);

// Returns the palette entry that all vertices of the part follow alone; none if there is no such entry.
uint32_t rigid_entry(const model::Part &part);

}  // namespace claque::meshsplit
