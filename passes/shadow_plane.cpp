#include "passes/shadow_plane.h"

#include <cmath>

namespace claque::passes
{
namespace
{

glm::dvec3 turned(const double *m, const glm::dvec3 &v)
{
    return {m[0] * v.x + m[3] * v.y + m[6] * v.z, m[1] * v.x + m[4] * v.y + m[7] * v.z,
            m[2] * v.x + m[5] * v.y + m[8] * v.z};
}

glm::dvec3 vec(const double *v) { return {v[0], v[1], v[2]}; }

// Light at a flatter angle would throw excessively long shadows.
constexpr double min_sine = 0.02;

}  // namespace

glm::dvec3 ShadowPlane::project(const glm::dvec3 &p) const
{
    if (parallel) return p - light * (above(p) / glm::dot(normal, light));
    const double height = above(light);
    return light + (p - light) * (height / (height - above(p)));
}

ShadowPlaneFinder::ShadowPlaneFinder(const ShadowOptions &options, const draw::DrawList &list)
    : options_(options),
      up_(turned(list.world_to_eye, vec(options.up))),
      eye_height_(glm::dot(vec(options.up), vec(list.eye)))
{
    const bool parallel = options.light[3] == 0;
    light_ = turned(list.world_to_eye, parallel ? vec(options.light) : vec(options.light) - vec(list.eye));
    if (parallel) light_ = light_ / std::sqrt(glm::dot(light_, light_));
}

double ShadowPlaneFinder::height_of(const draw::Item &item)
{
    if (options_.ground == ShadowGround::plane) return options_.plane_height;
    if (options_.ground == ShadowGround::host) {
        double height = std::nan("");
        host_calls_.run("clq_shadow_def.height", item.actor_index + 1,
                        [&] { height = options_.height(options_.user, item.ground); });
        return height;
    }
    return glm::dot(vec(options_.up), vec(item.ground));
}

bool ShadowPlaneFinder::find(const draw::Item &item, ShadowPlane &plane)
{
    plane.normal = up_;
    plane.offset = height_of(item) + options_.lift - eye_height_;
    plane.light = light_;
    plane.parallel = options_.light[3] == 0;
    if (!(plane.offset < 0)) return false;
    if (plane.parallel) return glm::dot(up_, light_) >= min_sine;
    const float *m = item.model_view;
    const auto at = [m](int i) { return static_cast<double>(m[i]); };
    const model::Sphere &sphere = item.tmpl->sklsroot;
    glm::dvec3 centre(at(12), at(13), at(14));
    for (int c = 0; c < 3; ++c)
        centre += glm::dvec3(at(4 * c), at(4 * c + 1), at(4 * c + 2)) * static_cast<double>(sphere.centre[c]);
    const double scale = std::sqrt(at(0) * at(0) + at(1) * at(1) + at(2) * at(2));
    const double top = plane.above(centre) + scale * static_cast<double>(sphere.radius);
    return plane.above(plane.light) > 1.01 * top;
}

Flattener::Flattener(const ShadowPlane &plane, const float *model_view, const draw::Vertices &vertices) : plane_(plane)
{
    const double step = vertices.packed() ? static_cast<double>(vertices.step) : 1.0;
    for (int r = 0; r < 3; ++r) {
        columns_[3][r] = static_cast<double>(model_view[12 + r]);
        for (int c = 0; c < 3; ++c) {
            const double m = static_cast<double>(model_view[4 * c + r]);
            if (vertices.packed()) columns_[3][r] += m * static_cast<double>(vertices.offset[c]);
            columns_[c][r] = m * step;
        }
    }
    project();
}

Flattener::Flattener(const ShadowPlane &plane, const float *model_view, const math::Affine &local) : plane_(plane)
{
    const glm::mat4 placed = math::mat4_of(local);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 3; ++r) {
            double sum = 0;
            for (int k = 0; k < 4; ++k)
                sum += static_cast<double>(model_view[4 * k + r]) * static_cast<double>(placed[c][k]);
            columns_[c][r] = sum;
        }
    project();
}

// For parallel light everything fits one matrix.
void Flattener::project()
{
    if (!plane_.parallel) return;
    const glm::dvec3 along = plane_.light / glm::dot(plane_.normal, plane_.light);
    for (int c = 0; c < 4; ++c) {
        const glm::dvec3 column = vec(columns_[c]);
        const double up = glm::dot(plane_.normal, column) - (c == 3 ? plane_.offset : 0.0);
        for (int r = 0; r < 3; ++r) columns_[c][r] -= along[r] * up;
    }
}

void Flattener::operator()(float x, float y, float z, float *out) const
{
    const double v[3] = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    glm::dvec3 p;
    for (int r = 0; r < 3; ++r)
        p[r] = columns_[0][r] * v[0] + columns_[1][r] * v[1] + columns_[2][r] * v[2] + columns_[3][r];
    if (!plane_.parallel) p = plane_.project(p);
    for (int r = 0; r < 3; ++r) out[r] = static_cast<float>(p[r]);
}

void Flattener::store(float *out) const
{
    for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 3; ++r) out[4 * c + r] = static_cast<float>(columns_[c][r]);
        out[4 * c + 3] = c == 3 ? 1.0f : 0.0f;
    }
}

}  // namespace claque::passes
