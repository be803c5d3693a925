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

// Returns the matches in the target's order, so ancestors come first. Without a map the options get the followers that
// belong to them. Throws base::Error (CLQ_ARGUMENT) if there are none.
std::vector<JointMatch> match_joints(const model::Rig &target, const model::Rig &source, Options &options,
                                     std::vector<std::string> &warnings);

// Drops joints on the ground that rest in all clips and carry one bound joint, such as the armature of an exporter: the
// path of the clips is that of the first joint that moves. Returns whether there were any.
bool drop_armatures(const model::Rig &target, const model::Rig &source, std::vector<JointMatch> &matches);

// Returns whether the joint hangs on the same bound joint in both skeletons, with nothing between them that moves.
bool hangs_alike(const model::Rig &source, const std::vector<JointMatch> &matches, const JointMatch &match);

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
