// What the extras of nodes (node_extras.h) say about the rig.
#pragma once

#include "lib/asset/gltf_clip.h"

namespace claque::asset
{

// Degrees of freedom in the order of the rig's nodes, and distances at which nodes stop. Throws base::Error (CLQ_FORMAT)
// where two have one name, or one moves a morph target that is not there.
void add_dofs(const NodeTree &tree, const RigMapping &mapping, model::Rig &rig);

}  // namespace claque::asset
