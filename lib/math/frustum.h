// The view volume of a projection as planes in eye space, and the sphere test of culling (S0 4.2).
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace claque::math
{

struct Plane {
    glm::dvec3 normal;  // unit, towards the inside
    double offset;      // dot(normal, p) + offset is the distance of p, inside positive
};

struct Frustum {
    Plane planes[6];  // left, right, bottom, top, near, far
    int count = 0;    // an infinite far plane leaves five
};

enum class Containment : unsigned char { outside = 0, intersects = 1, inside = 2 };

// A part of a picture in normalised device coordinates: -1 is its left or lower edge, 1 the opposite one.
struct Bounds {
    double left = -1, right = 1, bottom = -1, top = 1;
};

// From a column-major GL projection, perspective or parallel, by the six bounds of clip space (Gribb and Hartmann
// 2001). `bounds`: what of the picture is in view.
Frustum frustum_of(const float projection[16], const Bounds &bounds = Bounds());

// The planes in axes rotated back: a point p is inside if `turned` * p is inside `frustum`.
Frustum rotated_back(const Frustum &frustum, const glm::dmat3 &turned);

// `outside` is certain; a sphere near an outside edge may give `intersects`.
Containment test(const Frustum &frustum, const glm::dvec3 &centre, double radius);

// Tests the volume that the sphere sweeps along `sweep`, as for a shadow caster. `outside` is certain.
Containment test_swept(const Frustum &frustum, const glm::dvec3 &centre, double radius, const glm::dvec3 &sweep);

}  // namespace claque::math
