#include "lib/math/rough_sphere.h"

#include <algorithm>
#include <cmath>

namespace claque::math
{

namespace
{

// Rounding of a number to single precision errs by 2^-24 of it at most, and so does each step of the test: about ten
// times in all. This is eighteen times as much.
constexpr double margin = 1.1e-6;

constexpr double least = 1e-37, largest = 1e37;  // far from where single precision ends

double sum_of(const glm::dvec3 &v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

double dot(const glm::dvec3 &a, const glm::dvec3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

RoughSphere rough_sphere_of(const glm::dvec3 &centre, double radius)
{
    RoughSphere out;
    const double rounded_up = radius * (1 + margin) + margin * sum_of(centre) + least;
    if (!(rounded_up <= largest && sum_of(centre) <= largest)) return out;
    out.x = static_cast<float>(centre.x), out.y = static_cast<float>(centre.y), out.z = static_cast<float>(centre.z);
    out.radius = static_cast<float>(rounded_up);
    return out;
}

RoughFrustum::RoughFrustum(const Frustum &frustum, const glm::dvec3 &eye, const glm::dvec3 &sweep)
{
    float values[4][8] = {};
    std::fill_n(values[3], 8, std::numeric_limits<float>::infinity());
    for (int i = 0; i < frustum.count; ++i) {
        const Plane &plane = frustum.planes[i];
        const double size = std::fabs(plane.offset) + sum_of(eye) + sum_of(sweep);
        if (!(size <= largest)) continue;
        for (int k = 0; k < 3; ++k) values[k][i] = static_cast<float>(plane.normal[k]);
        const double swept = plane.offset - dot(plane.normal, eye) + std::fmax(dot(plane.normal, sweep), 0.0);
        values[3][i] = static_cast<float>(swept + margin * size);
    }
    for (int half = 0; half < 2; ++half) {
        x[half] = load4(values[0] + 4 * half), y[half] = load4(values[1] + 4 * half);
        z[half] = load4(values[2] + 4 * half), offset[half] = load4(values[3] + 4 * half);
    }
}

}  // namespace claque::math
