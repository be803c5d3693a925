// The corners of a triangle in the picture, and the weights of a point of the picture between them.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lib/visibility/found.h"

namespace claque::visibility
{

struct Corners {
    glm::dvec3 eye[3];   // in eye space
    glm::dvec3 clip[3];  // x, y and w after the projection

    bool faces_away(bool mirrored) const;
    // Weights of the corners, which sum to 1, for a point of the picture, -1 to 1 each way. A point beside the triangle
    // takes the weights of the nearest point of it, because GL rounds corners to a part of a pixel. NaN where the
    // triangle is seen edge on. half_px: half the picture's size.
    glm::dvec3 weights_at(const glm::dvec2 &point, const glm::dvec2 &half_px) const;
    glm::dvec3 unbounded(const glm::dvec2 &point) const;  // of the triangle's plane
};

Corners corners_of(const draw::DrawList &list, const draw::Item &item, const draw::Vertices &vertices,
                   const uint32_t *corners);

// A point in eye space after a projection, column-major: x, y and w.
glm::dvec3 clip_of(const float *projection, const glm::dvec3 &eye);

}  // namespace claque::visibility
