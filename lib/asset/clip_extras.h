// How a glTF file says what happens in a clip, and that its way over the ground is to be taken out of its poses. In
// `extras` of an animation, which the format leaves to us.
//
//   "extras": {"claque": {
//       "markers": [                     moments with names, in any order
//           {"name": "left foot down",   required
//            "time_s": 0.25}             required: on the axis of the animation's key times, between its first and last
//       ],
//       "root_motion": "hips"            whose way over the ground is taken out: the name of a node
//   }}
//
// Unknown members are passed over.
#pragma once

#include "lib/asset/gltf_file.h"

namespace claque::asset
{

// Of the rig's last clip; `extras` may be absent. Throws base::Error: CLQ_FORMAT, CLQ_LIMIT.
void read_clip_extras(const JsonView &extras, File &file, model::Rig &rig);

}  // namespace claque::asset
