// Templates in a pose: positions of their vertices, and whether the spheres of their parts hold them.
#pragma once

#include <glm/geometric.hpp>

#include "articulated.h"
#include "meshsplit/vertex_cloud.h"

namespace claque::test
{

// Corners of all triangles in a pose with degrees of freedom at rest and the level's active nodes.
inline std::vector<glm::vec3> posed(const model::Template &tmpl, size_t level_index, uint32_t clip, double time_s)
{
    const model::Level &level = tmpl.levels[level_index];
    const model::Rig &rig = tmpl.rig;
    std::vector<math::Trs> locals(rig.node_count());
    std::vector<math::Columns> globals(rig.node_count());
    std::vector<math::Affine> palette(rig.palette.size() + 1);
    std::vector<float> weights(rig.rest_weights.size());
    for (math::Affine &a : palette)
        for (float &c : a.c) c = std::numeric_limits<float>::quiet_NaN();  // what is not evaluated must not be used
    pose::PoseJob job;
    job.rig = &rig;
    job.clip = clip, job.time_s = time_s;
    job.level = &level;
    job.locals = base::Span<math::Trs>(locals);
    job.globals = base::Span<math::Columns>(globals);
    job.palette = base::Span<math::Affine>(palette);
    job.weights = base::Span<float>(weights);
    job.run();
    const meshsplit::VertexCloud cloud(level, rig);
    std::vector<glm::vec3> out;
    for (const uint32_t v : corners_of(level)) out.push_back(cloud.skinned(v, palette.data(), weights.data()));
    return out;
}

inline float largest_difference(const std::vector<glm::vec3> &a, const std::vector<glm::vec3> &b)
{
    if (a.size() != b.size() || a.empty()) return for_ever;
    float most = 0;
    for (size_t i = 0; i < a.size(); ++i) most = std::max(most, glm::distance(a[i], b[i]));
    return std::isnan(most) ? for_ever : most;
}

// Source vertices of the triangles of a part.
inline std::vector<uint32_t> corners_of(const model::Level &level, uint32_t part)
{
    if (level.parts.size() == 1) return corners_of(level);
    std::vector<uint32_t> out;
    for (const model::Surface &surface : level.surfaces) {
        const uint32_t *firsts = surface.part_offsets.data() + part;
        const auto add = [&](model::IndexRange range) {
            for (uint32_t i = firsts[0]; i < firsts[1]; ++i) out.push_back(level.indices[range.first + i]);
            firsts += level.parts.size() + 1;
        };
        for (const model::Bin &bin : surface.clean) add(bin.range);
        add(surface.dirty);
    }
    return out;
}

// Every part's vertices in a pose lie inside the hull of its spheres: none is farther in any direction.
inline void expect_held(const model::Template &tmpl, const model::Level &level, const math::Affine *palette,
                        const float *weights)
{
    const meshsplit::VertexCloud cloud(level, tmpl.rig);
    for (uint32_t p = 0; p < level.parts.size(); ++p) {
        std::vector<glm::vec3> points;
        for (const uint32_t v : corners_of(level, p)) points.push_back(cloud.skinned(v, palette, weights));
        for (int d = 0; d < 27; ++d) {
            const glm::vec3 axis(float(d % 3 - 1), float(d / 3 % 3 - 1), float(d / 9 - 1));
            if (axis == glm::vec3(0)) continue;
            const glm::vec3 unit = glm::normalize(axis);
            float vertices = -for_ever, spheres = -for_ever;
            for (const glm::vec3 &point : points) vertices = std::max(vertices, glm::dot(unit, point));
            for (uint32_t s = 0; s < level.parts[p].sphere_count; ++s) {
                const model::PartSphere &sphere = level.part_spheres[level.parts[p].first_sphere + s];
                const math::Affine &m = palette[sphere.entry];
                // How far the matrix takes a ball of radius 1 along `unit`: exact for shears, too.
                const float reach = glm::length(
                    glm::vec3(glm::dot(unit, m.column(0)), glm::dot(unit, m.column(1)), glm::dot(unit, m.column(2))));
                spheres = std::max(
                    spheres, glm::dot(unit, math::transform_point(m, sphere.bind.centre)) + reach * sphere.bind.radius);
            }
            ASSERT_LE(vertices, spheres) << "part " << p;
        }
    }
}

}  // namespace claque::test
