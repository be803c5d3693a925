// What the rest pose and the clips of a rig say about its matrices.
#pragma once

#include "lib/model/rig.h"

namespace claque::meshsplit
{

// Of each node relative to its parent, at rest, degrees of freedom included.
std::vector<math::Affine> rest_locals(const model::Rig &rig);

// Of each palette entry in the rest pose: node in model space times inverse bind.
std::vector<math::Affine> rest_palette(const model::Rig &rig);

// Whether every palette matrix is a similarity (mirrored or not) in every pose: all scales uniform, at rest and in all
// keys, all inverse binds similarities.
bool similar_only(const model::Rig &rig);

}  // namespace claque::meshsplit
