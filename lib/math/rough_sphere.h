// Spheres and frusta in single precision, for a first test of very many: 16 bytes and a few vector instructions each.
// All rounding is outwards, so what is outside here is outside in double precision too (frustum.h).
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

#include "lib/math/frustum.h"
#include "lib/math/simd.h"

namespace claque::math
{

// In the world. The default holds everything.
struct RoughSphere {
    float x = 0, y = 0, z = 0;
    float radius = std::numeric_limits<float>::infinity();
};

RoughSphere rough_sphere_of(const glm::dvec3 &centre, double radius);

// A frustum in the world, swept against `sweep`: it meets the spheres that meet the frustum while they move along it.
struct RoughFrustum {
    RoughFrustum(const Frustum &frustum, const glm::dvec3 &eye, const glm::dvec3 &sweep);
    F4 x[2], y[2], z[2], offset[2];  // of eight planes; the last ones hold everything
};

// Certain. A sphere with a number that is not finite is never outside.
inline bool is_outside(const RoughFrustum &frustum, const RoughSphere &sphere)
{
    const F4 x = splat(sphere.x), y = splat(sphere.y), z = splat(sphere.z), radius = splat(sphere.radius);
    const auto is_beyond = [&](int k) {
        const auto beyond =
            frustum.x[k] * x + frustum.y[k] * y + frustum.z[k] * z + (frustum.offset[k] + radius) < splat(0);
        uint64_t lanes[2];
        std::memcpy(lanes, &beyond, sizeof lanes);
        return (lanes[0] | lanes[1]) != 0;
    };
    return is_beyond(0) || is_beyond(1);  // the sides of the picture first: few are beyond the others alone
}

}  // namespace claque::math
