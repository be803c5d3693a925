#include "lib/figures/ambient_occlusion.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lib/math/trig.h"

namespace claque::figures
{

namespace
{

constexpr float cell_size = 0.04f;
constexpr float reach_m = 0.16f;
constexpr int ray_count = 16;

// Directions over the hemisphere about +z, denser near it (cosine law), placed by the golden angle.
std::array<glm::vec3, ray_count> make_rays()
{
    std::array<glm::vec3, ray_count> rays;
    for (int i = 0; i < ray_count; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) / ray_count;
        const float angle = 2.39996323f * static_cast<float>(i);
        const float r = std::sqrt(u);
        rays[static_cast<size_t>(i)] = glm::vec3(r * math::cos(angle), r * math::sin(angle), std::sqrt(1 - u));
    }
    return rays;
}

}  // namespace

AmbientOcclusion::AmbientOcclusion(const Mesh &mesh)
{
    glm::vec3 high(-1e9f);
    low_ = glm::vec3(1e9f);
    for (const Point &p : mesh.points) low_ = glm::min(low_, p.position), high = glm::max(high, p.position);
    low_ -= glm::vec3(0.01f);
    cells_ = glm::ivec3((high - low_) / cell_size) + 2;
    grid_.resize(static_cast<size_t>(cells_.x) * static_cast<size_t>(cells_.y) * static_cast<size_t>(cells_.z));
    for (const Face &f : mesh.faces) {
        const glm::vec3 a = mesh.points[f.corners[0].point].position, b = mesh.points[f.corners[1].point].position,
                        c = mesh.points[f.corners[2].point].position;
        const uint32_t index = static_cast<uint32_t>(triangles_.size());
        triangles_.push_back({a, b - a, c - a});
        const glm::ivec3 first = cell_of(glm::min(a, glm::min(b, c))), last = cell_of(glm::max(a, glm::max(b, c)));
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x)
                    grid_[static_cast<size_t>((z * cells_.y + y) * cells_.x + x)].push_back(index);
    }
}

glm::ivec3 AmbientOcclusion::cell_of(glm::vec3 p) const
{
    return glm::clamp(glm::ivec3((p - low_) / cell_size), glm::ivec3(0), cells_ - 1);
}

const std::vector<uint32_t> &AmbientOcclusion::cell(glm::ivec3 c) const
{
    return grid_[static_cast<size_t>((c.z * cells_.y + c.y) * cells_.x + c.x)];
}

bool AmbientOcclusion::blocked(glm::vec3 from, glm::vec3 direction, float reach) const
{
    // Steps of half a cell may miss a corner; soft shadows do not show it.
    glm::ivec3 before(-1);
    for (float s = 0; s < reach; s += cell_size / 2) {
        const glm::ivec3 at = cell_of(from + direction * s);
        if (at == before) continue;
        before = at;
        for (const uint32_t i : cell(at)) {
            const Triangle &t = triangles_[i];
            const glm::vec3 p = glm::cross(direction, t.ac);
            const float det = glm::dot(t.ab, p);
            if (std::fabs(det) < 1e-12f) continue;
            const glm::vec3 to = from - t.a;
            const float u = glm::dot(to, p) / det;
            if (u < 0 || u > 1) continue;
            const glm::vec3 q = glm::cross(to, t.ab);
            const float v = glm::dot(direction, q) / det;
            if (v < 0 || u + v > 1) continue;
            const float distance = glm::dot(t.ac, q) / det;
            if (distance > 0 && distance < reach) return true;
        }
    }
    return false;
}

float AmbientOcclusion::ambient_visibility(glm::vec3 position, glm::vec3 normal) const
{
    static const std::array<glm::vec3, ray_count> rays = make_rays();
    const glm::vec3 helper = std::fabs(normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 x = glm::normalize(glm::cross(helper, normal)), y = glm::cross(normal, x);
    const glm::vec3 from = position + normal * 0.006f;
    int free = 0;
    for (const glm::vec3 &r : rays) free += blocked(from, x * r.x + y * r.y + normal * r.z, reach_m) ? 0 : 1;
    return static_cast<float>(free) / ray_count;
}

}  // namespace claque::figures
