#include "lib/frame/view.h"

#include <cmath>

#include "lib/base/error.h"
#include "lib/base/hash.h"
#include "lib/math/trig.h"

namespace claque::frame
{

namespace
{

glm::dvec3 unit(const glm::dvec3 &v) { return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

double square(const glm::dvec3 &v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

// Shepperd's method: starts from the largest component, so that no root of a small number is taken. Columns x, y, z are
// rows of a world-to-eye rotation.
glm::quat quat_of(const glm::dvec3 &x, const glm::dvec3 &y, const glm::dvec3 &z)
{
    const double m[3][3] = {{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}};  // [row][column]
    const double trace = m[0][0] + m[1][1] + m[2][2];
    double q[4];  // x y z w
    if (trace > 0) {
        const double s = std::sqrt(trace + 1) * 2;
        q[3] = s / 4;
        for (int i = 0; i < 3; ++i) q[i] = (m[(i + 2) % 3][(i + 1) % 3] - m[(i + 1) % 3][(i + 2) % 3]) / s;
    } else {
        const int i = m[0][0] > m[1][1] ? (m[0][0] > m[2][2] ? 0 : 2) : (m[1][1] > m[2][2] ? 1 : 2);
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double s = std::sqrt(1 + m[i][i] - m[j][j] - m[k][k]) * 2;
        q[i] = s / 4;
        q[j] = (m[j][i] + m[i][j]) / s;
        q[k] = (m[k][i] + m[i][k]) / s;
        q[3] = (m[k][j] - m[j][k]) / s;
    }
    return glm::quat(float(q[3]), float(q[0]), float(q[1]), float(q[2]));
}

}  // namespace

Camera look_at(const glm::dvec3 &eye, const glm::dvec3 &target, const glm::vec3 &up, float fov_y_rad, float aspect,
               float z_near, float z_far)
{
    if (!(fov_y_rad > 0 && fov_y_rad < float(math::pi)) || !(aspect > 0) || !(z_near > 0) || !(z_far > z_near) ||
        !std::isfinite(aspect) || !std::isfinite(z_far))
        base::fail(
            CLQ_ARGUMENT,
            "a perspective of %g rad, aspect %g, from %g to %g: 0 to pi, above 0 and 0 < z_near < z_far are wanted",
            double(fov_y_rad), double(aspect), double(z_near), double(z_far));
    const glm::dvec3 direction = target - eye;
    if (!(square(direction) > 0) || !std::isfinite(square(direction)))
        base::fail(CLQ_ARGUMENT, "the eye and what it looks at are the same point, or not finite");
    const glm::dvec3 back = -unit(direction);
    const glm::dvec3 side = glm::cross(glm::dvec3(up), back);
    if (!(square(side) > 1e-12 * square(glm::dvec3(up)))) base::fail(CLQ_ARGUMENT, "up lies along the line of sight");

    const double scale = 1 / math::tan(fov_y_rad / 2.0), n = z_near, f = z_far;
    for (const double x : {scale, scale / aspect})
        if (!std::isfinite(static_cast<float>(x)))
            base::fail(CLQ_ARGUMENT, "%g rad at aspect %g is narrower than a projection's numbers reach",
                       double(fov_y_rad), double(aspect));

    Camera camera;
    const glm::dvec3 right = unit(side);
    camera.eye = eye;
    camera.rotation = quat_of(right, glm::cross(back, right), back);
    for (float &x : camera.projection) x = 0;
    camera.projection[0] = float(scale / aspect);
    camera.projection[5] = float(scale);
    camera.projection[10] = float((f + n) / (n - f));
    camera.projection[11] = -1;
    camera.projection[14] = float(2 * f * n / (n - f));
    return camera;
}

uint64_t hash(const draw::DrawList &list)
{
    uint64_t h = base::fnv(base::fnv_start, list.projection, sizeof list.projection);
    for (const draw::Item &item : list.items) {
        const model::Level &level = item.tmpl->levels[item.level];
        const draw::Vertices &vertices = item.vertices;
        h = base::fnv(h, item.tmpl->name.data(), item.tmpl->name.size());
        h = base::fnv(h, &item.level, sizeof item.level);
        h = base::fnv(h, &item.actor_index, sizeof item.actor_index);
        h = base::fnv(h, item.model_view, sizeof item.model_view);
        h = base::fnv(h, &item.eye_distance_m, sizeof item.eye_distance_m);
        const unsigned char flags = static_cast<unsigned char>(item.mirrored + 2 * (item.zone_rgb != nullptr) +
                                                               4 * (item.hooks != nullptr) + 8 * item.shadow_only);
        h = base::fnv(h, &flags, 1);
        if (item.zone_rgb) h = base::fnv(h, item.zone_rgb, 3 * size_t(item.tmpl->zone_count()));
        if (~item.parts) h = base::fnv(h, &item.parts, sizeof item.parts);
        if (item.locals) {
            h = base::fnv(h, item.locals, sizeof(math::Affine) * item.tmpl->rig.node_count());
            continue;
        }
        if (vertices.packed()) {
            h = base::fnv(h, vertices.short_positions, 4 * sizeof(int16_t) * level.vertex_count);
            h = base::fnv(h, vertices.byte_normals, 4 * level.vertex_count);
            h = base::fnv(h, vertices.offset, sizeof vertices.offset);
            h = base::fnv(h, &vertices.step, sizeof vertices.step);
            continue;
        }
        if (!vertices.any()) continue;  // no memory for them
        h = base::fnv(h, vertices.positions, 3 * sizeof(float) * level.vertex_count);
        h = base::fnv(h, vertices.normals, 3 * sizeof(float) * level.vertex_count);
    }
    return h;
}

uint64_t triangle_count(const draw::DrawList &list)
{
    uint64_t sum = 0;
    for (const draw::Item &item : list.items) {
        if (item.shadow_only) continue;
        const model::Level &level = item.tmpl->levels[item.level];
        if (!level.parts.empty()) {
            for (uint32_t k = 0; k < level.parts.size(); ++k)
                if (item.parts >> k & 1) sum += level.parts[k].triangles;
            continue;
        }
        for (const model::Surface &surface : level.surfaces) {
            sum += surface.dirty.count / 3;
            for (const model::Bin &bin : surface.clean) sum += bin.range.count / 3;
        }
    }
    return sum;
}

}  // namespace claque::frame
