// Adds to the rig what the extras of nodes (node_extras.h) define.
#pragma once

#include "lib/asset/gltf_clip.h"

namespace claque::asset
{

// Adds degrees of freedom in the order of the rig's nodes, and deactivation distances. Throws base::Error (CLQ_FORMAT)
// if two degrees of freedom have one name, or one moves a missing morph target.
void add_dofs(const NodeTree &tree, const RigMapping &mapping, model::Rig &rig);

}  // namespace claque::asset
