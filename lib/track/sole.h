// The points of a foot that touch the ground, from the mesh as it stands.
#pragma once

#include "lib/pose/pose.h"

namespace claque::track
{

// Sets ball and heel of a leg whose nodes are set, in the pose that `work` was left in. A foot without vertices gets
// points below its nodes.
//   toes   the node of the toes, or none: the ball is where the foot is broadest ahead of the ankle
void set_sole(const model::Template &tmpl, const pose::Workspace &work, uint32_t toes, pose::Leg &leg);

}  // namespace claque::track
