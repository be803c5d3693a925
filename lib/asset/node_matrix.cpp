#include "lib/asset/node_matrix.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace claque::asset
{

namespace
{

// A unit vector perpendicular to `v`.
glm::dvec3 across(const glm::dvec3 &v)
{
    const glm::dvec3 other = std::fabs(v.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(v, other));
}

// Normalises the axes that have a length and chooses the others perpendicular to them.
void complete(glm::dvec3 axis[3], const double length[3], double tiny)
{
    for (int k = 0; k < 3; ++k) axis[k] = length[k] > tiny ? axis[k] / length[k] : glm::dvec3(0);
    const auto has = [&](int k) { return length[k] > tiny; };
    const int count = has(0) + has(1) + has(2);
    if (count == 0) axis[0] = glm::dvec3(1, 0, 0), axis[1] = glm::dvec3(0, 1, 0), axis[2] = glm::dvec3(0, 0, 1);
    if (count == 1) {
        const int k = has(0) ? 0 : has(1) ? 1 : 2;
        axis[(k + 1) % 3] = across(axis[k]);
        axis[(k + 2) % 3] = glm::cross(axis[k], axis[(k + 1) % 3]);
    }
    if (count == 2) {
        const int k = !has(0) ? 0 : !has(1) ? 1 : 2;
        const glm::dvec3 c = glm::cross(axis[(k + 1) % 3], axis[(k + 2) % 3]);
        axis[k] = glm::length(c) > 1e-9 ? glm::normalize(c) : across(axis[(k + 1) % 3]);
    }
}

}  // namespace

DecomposedMatrix decompose(const float m[16])
{
    glm::dvec3 given[3], axis[3];
    double length[3], longest = 0;
    for (int k = 0; k < 3; ++k) {
        given[k] = axis[k] = glm::dvec3(m[4 * k], m[4 * k + 1], m[4 * k + 2]);
        length[k] = glm::length(given[k]);
        longest = std::fmax(longest, length[k]);
    }
    complete(axis, length, 1e-12 * longest);
    if (glm::dot(glm::cross(axis[0], axis[1]), axis[2]) < 0) axis[0] = -axis[0], length[0] = -length[0];

    // The rotation that is nearest to the axes; the rest is the error.
    const glm::dquat q = glm::normalize(glm::quat_cast(glm::dmat3(axis[0], axis[1], axis[2])));
    const glm::dmat3 turned = glm::mat3_cast(q);
    DecomposedMatrix out;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 off = turned[k] * length[k] - given[k];
        if (longest > 0) out.error = std::fmax(out.error, glm::length(off) / longest);
        out.trs.scale[k] = static_cast<float>(length[k]);
        out.trs.translation[k] = m[12 + k];
    }
    out.trs.rotation =
        glm::quat(static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z));
    return out;
}

}  // namespace claque::asset
