// The facing of a person in its clips, as pictures show clips. The rest pose of a file may face elsewhere.
#pragma once

#include "lib/model/facing.h"
#include "lib/model/template.h"

namespace claque::pose
{

// In the middle of a clip. `motion` may be null.
model::Facing facing_in(const model::Rig &rig, const model::Motion *motion, uint32_t clip);

// In most of its first clips in which it stands and does not turn; at rest where it has no clips.
model::Facing facing_in_clips(const model::Rig &rig);

}  // namespace claque::pose
