// Matches joints of the source with joints of the target, and computes rest poses. Internal to lib/retarget.
#pragma once

#include <glm/gtc/quaternion.hpp>

#include "lib/retarget/retarget.h"

namespace claque::retarget
{

struct JointMatch {
    uint32_t source = 0, target = 0;
    RestAlignment rest = RestAlignment::keep;
    uint32_t above = model::none;  // match of the nearest matched ancestor in the target
};

// Returns the matches in the target's order, so ancestors come first. Throws base::Error (CLQ_ARGUMENT) if there are
// none.
std::vector<JointMatch> match_joints(const model::Rig &target, const model::Rig &source, const Options &options,
                                     std::vector<std::string> &warnings);

// Returns whether any clip moves the node out of its rest pose; files also hold channels of nodes at rest.
bool moves(const model::Rig &rig, uint32_t node);

// Rotations and positions in model space. Scales affect positions only.
struct GlobalPose {
    std::vector<glm::dquat> rotations;
    std::vector<glm::dvec3> positions;
    std::vector<math::Affine> globals;
};
GlobalPose rest_pose(const model::Rig &rig);

inline glm::dquat dquat_of(const glm::quat &q) { return glm::dquat(q.w, q.x, q.y, q.z); }
inline glm::dvec3 dvec_of(const glm::vec3 &v) { return glm::dvec3(v); }

}  // namespace claque::retarget
