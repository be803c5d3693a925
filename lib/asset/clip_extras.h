// Markers and root motion of a clip, in the `extras` of a glTF animation. The format leaves the content of extras to
// applications.
//
//   "extras": {"claque": {
//       "markers": [                     named times of the clip, in any order
//           {"name": "left foot down",   required
//            "time_s": 0.25}             required: on the axis of the animation's key times, between first and last
//       ],
//       "root_motion": "hips"            name of the node whose horizontal movement is taken out of the clip's poses
//   }}
//
// Unknown members are ignored.
#pragma once

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

// Reads the extras of the rig's last clip; `extras` may be absent. Throws base::Error: CLQ_FORMAT, CLQ_LIMIT.
void read_clip_extras(const JsonView &extras, File &file, model::Rig &rig);

}  // namespace claque::asset
