// The rig of a Template from that of a Model: without what only hidden parts need, in the order in which poses read it.
#pragma once

#include "meshsplit/allowance.h"

namespace claque::meshsplit
{

// Fills `out`, which is empty. Each channel has its keys to itself, one channel after the other (files share them among
// channels); morph sets that no part in sight uses are left out with the channels that animate them; root motions are
// taken out of their clips. `model` has passed model::check. Returns for each of its morph sets the first weight in
// `out`, none where the set is left out. Throws base::Error (CLQ_ARGUMENT).
// `allowance` pays for what becomes longer.
std::vector<uint32_t> fill_rig(const model::Model &model, Allowance &allowance, model::Rig &out);

}  // namespace claque::meshsplit
