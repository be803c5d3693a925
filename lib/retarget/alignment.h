// Aligns two skeletons at rest: axes, size, and a rotation for each bone between the rest poses. Internal to
// lib/retarget.
#pragma once

#include "lib/retarget/joints.h"

namespace claque::retarget
{

struct SkeletonAlignment {
    glm::dquat axes = glm::dquat(1, 0, 0, 0);  // from the source's model space to the target's
    double scale = 1;                          // of translations, by the ratio of leg lengths
    std::vector<glm::dquat> aligned;           // [matches] from the target's bone at rest to the source's
};

// Returns the axis rotation, one of 24, under which the joints are most similar; files differ in their up and forward
// axes.
glm::dquat common_axes(const std::vector<JointMatch> &matches, const GlobalPose &target, const GlobalPose &source);

SkeletonAlignment align_skeletons(const std::vector<JointMatch> &matches, const GlobalPose &target,
                                  const GlobalPose &source, const glm::dquat &axes);

// Returns the shortest rotation from one direction to the other: the identity if either has no length, a half turn
// about any perpendicular axis if they are opposite.
glm::dquat rotation_between(glm::dvec3 from, glm::dvec3 to);

}  // namespace claque::retarget
