// Takes the way over the ground out of a clip, so that a host can move the Reference Point by it instead.
#pragma once

#include "lib/model/rig.h"

namespace claque::meshsplit
{

// Of one node in model space: translation along x and z, and the turn about y, against the clip's beginning. The node's
// channels of the clip are written anew, 60 times a second and at their old keys, LINEAR; a track is added to the rig, in the
// order of clips. Throws base::Error (CLQ_ARGUMENT): a node above is animated by the clip, or the clip has a track already.
void extract_root_motion(model::Rig &rig, uint32_t clip, uint32_t node);

}  // namespace claque::meshsplit
