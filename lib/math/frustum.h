// What a projection can show, as planes in eye space, and the sphere test that culling uses (S0 4.2).
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
    int count = 0;    // planes that bound anything: an infinite far plane leaves five
};

enum class Containment : unsigned char { outside = 0, intersects = 1, inside = 2 };

// Of a column-major GL projection, perspective or parallel, from clip space's six bounds (Gribb and Hartmann 2001).
Frustum frustum_of(const float projection[16]);

// The same planes where the axes are turned: inside is where the frustum of `turned` * p was.
Frustum rotated_back(const Frustum &frustum, const glm::dmat3 &turned);

// `no` is certain; a sphere near an edge outside may be said to cross.
Containment test(const Frustum &frustum, const glm::dvec3 &centre, double radius);

// Of all that the sphere sweeps on its way by `way`: a shadow's caster. `no` is certain.
Containment test_swept(const Frustum &frustum, const glm::dvec3 &centre, double radius, const glm::dvec3 &sweep);

}  // namespace claque::math
