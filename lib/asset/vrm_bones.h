// Reads which nodes are parts of a human body: VRMC_vrm (VRM 1.0), VRM (0.x) and VRMC_vrm_animation (.vrma).
#pragma once

#include "lib/asset/budget.h"
#include "lib/asset/json_view.h"

namespace claque::asset
{

// Returns VRM's names of bones and nodes of the rig. Entries that break a rule of the extension, or whose nodes are not
// shown, are left out: nothing but the binding of clips needs them. `rig_node`: by node of the file.
std::vector<std::pair<std::string, uint32_t>> read_vrm_bones(const JsonView &root,
                                                             const std::vector<uint32_t> &rig_node, Budget &budget);

}  // namespace claque::asset
