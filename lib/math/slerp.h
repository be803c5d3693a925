// Spherical interpolation of unit quaternions by the shorter arc, without acos or sin: glTF 2.0, appendix C.4.
#pragma once

#include <glm/gtc/quaternion.hpp>

namespace claque::math
{

// f in [0, 1]. The result is a unit quaternion (float rounding apart); keys that are not quite unit do no harm.
// Error of the angle below 1e-9 rad before rounding to float.
glm::quat slerp(const float a_xyzw[4], const float b_xyzw[4], double f);

// Of length 1; the identity for a quaternion of no length.
glm::quat unit_quat(double w, double x, double y, double z);

}  // namespace claque::math
