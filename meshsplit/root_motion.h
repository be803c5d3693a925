// Extracts root motion: takes the horizontal motion out of a clip, so that a host can move the Reference Point by it.
#pragma once

#include "meshsplit/allowance.h"

namespace claque::meshsplit
{

// Extracts the motion of one node in model space, relative to the clip's start: translation along x and z, and rotation
// about y. The node's channels of the clip are resampled at 60 Hz and at their old keys, LINEAR. A root curve is added
// to the rig, in the order of clips. Throws base::Error (CLQ_ARGUMENT) if the clip animates an ancestor of the node or
// has root motion already.
void extract_root_motion(model::Rig &rig, uint32_t clip, uint32_t node);

// All that `model` asks for, out of a rig made from its own; what comes of very large numbers is checked again. Throws
// base::Error (LIMIT) if the samples would take more than `allowance` has.
void extract_root_motions(const model::Model &model, Allowance &allowance, model::Rig &rig);

}  // namespace claque::meshsplit
