// Joints that give way to bound ones: cloth that goes with a thigh.
#pragma once

#include "lib/retarget/joints.h"

namespace claque::retarget
{

struct Following {
    uint32_t joint = 0;            // of the target
    uint32_t leader = 0;           // a match
    uint32_t above = model::none;  // the match of the nearest bound joint above it
    double share = 1;
};

// Throws base::Error (CLQ_ARGUMENT) for names that are not there, a joint that is bound itself, and shares out of range.
std::vector<Following> match_followers(const model::Rig &target, const std::vector<Match> &matches,
                                       const Options &options);

// Its rotation as its parent sees it. `turns`: of the matches, in model space.
glm::dquat local_of(const Following &following, const model::Rig &target, const Stance &rest,
                    const std::vector<Match> &matches, const std::vector<glm::dquat> &turns);

// So much of a turn, by the shorter way.
glm::dquat share_of(const glm::dquat &turn, double share);

}  // namespace claque::retarget
