// How layers meet at one joint: by the shorter arc, on the chord, made unit again. The kernels of kernel.h do the same to
// eight joints at once.
#pragma once

#include <glm/gtc/quaternion.hpp>

namespace claque::pose
{

// `weight` of the way from unit `a` to unit `b`.
glm::quat nlerp(const glm::quat &a, const glm::quat &b, float weight);

// `below`, then `weight` of the turn from `from` to `to`, as seen from the joint (S2 3.3). Any finite weight: less than 0
// turns back, more than 1 turns farther.
glm::quat add_rotation(const glm::quat &below, const glm::quat &from, const glm::quat &to, float weight);

}  // namespace claque::pose
