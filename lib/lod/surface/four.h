// Four points, triangles or boxes at once, as floats. Internal to lib/lod.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "lib/math/simd.h"

namespace claque::lod
{

using Four3 = std::array<math::F4, 3>;

inline Four3 splat(glm::dvec3 p) { return {math::splat(float(p.x)), math::splat(float(p.y)), math::splat(float(p.z))}; }
inline Four3 minus(const Four3 &a, const Four3 &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline math::F4 dot(const Four3 &a, const Four3 &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline math::F4 smaller(math::F4 a, math::F4 b) { return a < b ? a : b; }
inline math::F4 larger(math::F4 a, math::F4 b) { return a > b ? a : b; }

inline Four3 cross(const Four3 &a, const Four3 &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline void set(Four3 &to, size_t lane, glm::dvec3 p)
{
    for (int axis = 0; axis < 3; ++axis) to[static_cast<size_t>(axis)][lane] = static_cast<float>(p[axis]);
}

}  // namespace claque::lod
