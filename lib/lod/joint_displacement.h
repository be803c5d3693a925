// How far joints part from one another when a character moves: what it costs a vertex to follow another one. Between the files
// of this room only.
#pragma once

#include "lib/lod/decimate.h"

namespace claque::lod
{

// [palette of `model`] how far, by the root of the mean of squares over poses of all clips, what follows a joint comes from
// where it would be if it followed the joint above instead; of joints that nothing is above or that nothing follows, 0.
// Empty where there are no clips. Deterministic.
std::vector<double> joint_displacements(const model::Model &model, const std::vector<SourcePart> &parts);

}  // namespace claque::lod
