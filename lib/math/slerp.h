// Spherical interpolation of unit quaternions along the shorter arc, without acos or sin: glTF 2.0, appendix C.4.
#pragma once

#include <glm/gtc/quaternion.hpp>

namespace claque::math
{

// f in [0, 1]. The result has unit length up to float rounding, also for keys that are only approximately unit. The
// error of the angle is below 1e-9 rad before rounding to float.
glm::quat slerp(const float a_xyzw[4], const float b_xyzw[4], double f);

// Normalises; the identity for a quaternion of length 0.
glm::quat unit_quat(double w, double x, double y, double z);

}  // namespace claque::math
