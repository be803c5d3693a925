// The axes of a flyer's own space: x to its left, y up, z ahead.
#pragma once

#include <glm/vec3.hpp>

namespace claque::figures::flyer
{

inline const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

}  // namespace claque::figures::flyer
