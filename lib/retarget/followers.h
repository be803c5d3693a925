// Joints that follow bound joints without a match of their own: cloth on a thigh. Internal to lib/retarget.
#pragma once

#include "lib/retarget/joints.h"

namespace claque::retarget
{

struct LeaderBinding {
    uint32_t match = 0;
    double share = 1;
    // `along`: the leader's bone. `side`: the side of it on which the follower lies; 0: unknown.
    glm::dvec3 along = glm::dvec3(0), side = glm::dvec3(0);
};

struct FollowerBinding {
    uint32_t joint = 0;                  // of the target
    uint32_t above = model::none;        // match of the nearest bound ancestor
    std::vector<LeaderBinding> leaders;  // in the order of Options::followers
};

// Throws base::Error (CLQ_ARGUMENT) for unknown names, a follower that is bound itself, and shares out of range.
std::vector<FollowerBinding> match_followers(const model::Rig &target, const std::vector<JointMatch> &matches,
                                             const Options &options);

// Returns the follower's rotation in its parent's space. `rotations`: of the matches, in model space.
glm::dquat local_rotation(const FollowerBinding &following, const model::Rig &target, const GlobalPose &rest,
                          const std::vector<JointMatch> &matches, const std::vector<glm::dquat> &rotations);

// Returns the fraction `share` of a rotation, along the shorter arc.
glm::dquat partial_rotation(const glm::dquat &rotation, double share);

}  // namespace claque::retarget
