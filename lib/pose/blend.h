// Blending of rotations by normalised linear interpolation along the shorter arc. The kernels of pose_kernels.h do the
// same for eight joints at once.
#pragma once

#include <glm/gtc/quaternion.hpp>

namespace claque::pose
{

// Interpolates from unit `a` to unit `b`.
glm::quat nlerp(const glm::quat &a, const glm::quat &b, float weight);

// Returns `below` followed by `weight` of the rotation from `from` to `to`, in the joint's space (S2 3.3). Any finite
// weight is allowed: below 0 it reverses the rotation, above 1 it extrapolates.
glm::quat add_rotation(const glm::quat &below, const glm::quat &from, const glm::quat &to, float weight);

}  // namespace claque::pose
