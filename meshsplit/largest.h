// The largest absolute component of a vector.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

namespace claque::meshsplit
{

inline double largest(const glm::vec3 &v)
{
    return std::max({std::fabs(double(v.x)), std::fabs(double(v.y)), std::fabs(double(v.z))});
}

}  // namespace claque::meshsplit
