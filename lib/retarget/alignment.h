// How one skeleton at rest lies in another: axes, size, and the turn of each bone from one rest pose to the other.
#pragma once

#include "lib/retarget/joints.h"

namespace claque::retarget
{

struct SkeletonAlignment {
    glm::dquat axes = glm::dquat(1, 0, 0, 0);  // from the source's model space to the target's: one of 24
    double scale = 1;                          // of ways, by the legs
    std::vector<glm::dquat> aligned;           // one a match: the target's bone at rest to the source's
};

SkeletonAlignment align_skeletons(const std::vector<JointMatch> &matches, const GlobalPose &target,
                                  const GlobalPose &source);

// The shortest turn of one direction into another; none where either has no length. Half a turn about any axis where
// they are opposite.
glm::dquat rotation_between(glm::dvec3 from, glm::dvec3 to);

}  // namespace claque::retarget
