#include "lib/visibility/corners.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace claque::visibility
{
glm::dvec3 clip_of(const float *p, const glm::dvec3 &e)
{
    const auto row = [&](int k) {
        return double(p[k]) * e.x + double(p[4 + k]) * e.y + double(p[8 + k]) * e.z + double(p[12 + k]);
    };
    return {row(0), row(1), row(3)};
}

namespace
{

// Removes what rounding leaves beside the triangle.
glm::dvec3 bounded(glm::dvec3 weights)
{
    for (int k = 0; k < 3; ++k) weights[k] = std::clamp(weights[k], 0.0, 1.0);
    return weights / (weights.x + weights.y + weights.z);
}

}  // namespace

bool Corners::faces_away(bool mirrored) const
{
    const double turn = glm::determinant(glm::dmat3(clip[0], clip[1], clip[2]));
    return (turn < 0) != mirrored;
}

glm::dvec3 Corners::unbounded(const glm::dvec2 &point) const
{
    const glm::dvec3 p(point, 1);
    // The columns of the adjugate: the weights of p's solution, times the determinant.
    const glm::dvec3 raw(glm::dot(glm::cross(clip[1], clip[2]), p), glm::dot(glm::cross(clip[2], clip[0]), p),
                         glm::dot(glm::cross(clip[0], clip[1]), p));
    return raw / (raw.x + raw.y + raw.z);
}

glm::dvec3 Corners::weights_at(const glm::dvec2 &point, const glm::dvec2 &half_px) const
{
    const glm::dvec3 inside = unbounded(point);
    if (inside.x >= 0 && inside.y >= 0 && inside.z >= 0) return inside;
    glm::dvec2 at[3];
    for (int k = 0; k < 3; ++k) {
        if (!(clip[k].z > 0)) return bounded(inside);  // behind the eye: edges have no place in the picture
        at[k] = glm::dvec2(clip[k]) / clip[k].z;
    }
    glm::dvec2 best(0);
    double nearest = HUGE_VAL;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec2 from = at[k] * half_px, edge = at[(k + 1) % 3] * half_px - from, to = point * half_px - from;
        const double square = glm::dot(edge, edge);
        const glm::dvec2 on = edge * (square > 0 ? std::clamp(glm::dot(to, edge) / square, 0.0, 1.0) : 0.0);
        const double distance = glm::dot(to - on, to - on);
        if (!(distance < nearest)) continue;
        nearest = distance;
        best = (from + on) / half_px;
    }
    return bounded(unbounded(best));
}

Corners corners_of(const draw::DrawList &list, const draw::Item &item, const draw::Vertices &vertices,
                   const uint32_t *corners)
{
    Corners out;
    const float *m = item.model_view;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 v(vertices.position(corners[k]));
        for (int i = 0; i < 3; ++i)
            out.eye[k][i] = double(m[i]) * v.x + double(m[4 + i]) * v.y + double(m[8 + i]) * v.z + double(m[12 + i]);
        out.clip[k] = clip_of(list.projection, out.eye[k]);
    }
    return out;
}

}  // namespace claque::visibility
