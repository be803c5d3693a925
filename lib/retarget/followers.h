// Joints that give way to bound ones: cloth that goes with a thigh.
#pragma once

#include "lib/retarget/joints.h"

namespace claque::retarget
{

struct LeaderBinding {
    uint32_t match = 0;
    double share = 1;
    glm::dvec3 along = glm::dvec3(0),
               side = glm::dvec3(0);  // its bone, and on which side of it the follower lies; 0: unknown
};

struct FollowerBinding {
    uint32_t joint = 0;                  // of the target
    uint32_t above = model::none;        // the match of the nearest bound joint above it
    std::vector<LeaderBinding> leaders;  // in the order in which they are listed
};

// Throws base::Error (CLQ_ARGUMENT) for names that are not there, a joint that is bound itself, and shares out of range.
std::vector<FollowerBinding> match_followers(const model::Rig &target, const std::vector<JointMatch> &matches,
                                             const Options &options);

// Its rotation as its parent sees it. `turns`: of the matches, in model space.
glm::dquat local_rotation(const FollowerBinding &following, const model::Rig &target, const GlobalPose &rest,
                          const std::vector<JointMatch> &matches, const std::vector<glm::dquat> &rotations);

// So much of a turn, by the shorter way.
glm::dquat partial_rotation(const glm::dquat &rotation, double share);

}  // namespace claque::retarget
