// Which joint of the source answers which of the target, and what both are at rest.
#pragma once

#include <glm/gtc/quaternion.hpp>

#include "lib/retarget/retarget.h"

namespace claque::retarget
{

struct JointMatch {
    uint32_t source = 0, target = 0;
    RestAlignment rest = RestAlignment::keep;
    uint32_t above = model::none;  // the match of the nearest joint above it in the target that has one
};

// In the target's order, so that what is above stands first. Throws base::Error (CLQ_ARGUMENT) where none is left.
std::vector<JointMatch> match_joints(const model::Rig &target, const model::Rig &source, const Options &options,
                                     std::vector<std::string> &warnings);

// Whether any clip takes it out of its rest: files also hold channels of what stands still.
bool moves(const model::Rig &rig, uint32_t node);

// Rotations and places in model space. Scales move places and turn nothing.
struct GlobalPose {
    std::vector<glm::dquat> rotations;
    std::vector<glm::dvec3> positions;
    std::vector<math::Affine> globals;
};
GlobalPose rest_pose(const model::Rig &rig);

inline glm::dquat dquat_of(const glm::quat &q) { return glm::dquat(q.w, q.x, q.y, q.z); }
inline glm::dvec3 dvec_of(const glm::vec3 &v) { return glm::dvec3(v); }

}  // namespace claque::retarget
