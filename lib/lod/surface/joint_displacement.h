// How far joints separate in a character's clips: the cost for a vertex to follow another joint. Internal to lib/lod.
#pragma once

#include "lib/lod/surface/source_part.h"

namespace claque::lod
{

// Returns [palette of `model`] the RMS displacement, over poses of its clips but late ones, of what follows a joint
// from where it would be if it followed the parent joint. 0 for joints without a parent or without vertices. Empty if
// there are no clips. Deterministic.
std::vector<double> joint_displacements(const model::Model &model, const std::vector<SourcePart> &parts);

}  // namespace claque::lod
