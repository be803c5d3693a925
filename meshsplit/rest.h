// Properties of the matrices of a rig, from its rest pose and clips.
#pragma once

#include "lib/model/rig.h"

namespace claque::meshsplit
{

// Returns the rest matrix of each node relative to its parent, degrees of freedom included.
std::vector<math::Affine> rest_locals(const model::Rig &rig);

// Returns the rest matrix of each palette entry: node in model space times inverse bind.
std::vector<math::Affine> rest_palette(const model::Rig &rig);

// Returns whether every palette matrix is a similarity (mirrored or not) in every pose: all scales are uniform, at rest
// and in all keys, and all inverse binds are similarities.
bool similar_only(const model::Rig &rig);

}  // namespace claque::meshsplit
