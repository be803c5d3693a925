// What tests ask of a built-in person: its mesh, the texels of a triangle, and the zones that they show.
#pragma once

#include <map>
#include <tuple>

#include "puppet.h"

namespace puppet
{

constexpr int texture_px = 512;  // the sides of each person's image

using Place = std::tuple<float, float, float>;
inline Place place(const claque::model::Part &part, uint32_t vertex)
{
    const vec3 p = part.positions[vertex];
    return {p.x, p.y, p.z};
}

inline uint8_t key_at(const Model &model, glm::vec2 uv)
{
    const glm::vec2 at = uv * float(texture_px);
    return model.images[0].rgba[4 * (size_t(at.y) * texture_px + size_t(at.x)) + 3];
}

// 255: there is none of this name.
inline uint8_t key_of(const Model &model, const std::string &zone)
{
    for (const claque::model::Zone &z : model.zones)
        if (z.name == zone) return z.key;
    return 255;
}

// Calls with the index of every texel whose centre lies inside the triangle.
template <class Visit>
void for_texels(const claque::model::Part &part, const std::array<uint32_t, 3> &triangle, Visit visit)
{
    glm::vec2 p[3];
    for (size_t k = 0; k < 3; ++k) p[k] = part.uvs[triangle[k]] * float(texture_px);
    const auto cross2 = [](glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; };
    const float area = cross2(p[1] - p[0], p[2] - p[0]);
    if (area == 0) return;
    const glm::vec2 low = min(p[0], min(p[1], p[2])), high = max(p[0], max(p[1], p[2]));
    for (int y = int(low.y); y <= std::min(texture_px - 1, int(high.y)); ++y)
        for (int x = int(low.x); x <= std::min(texture_px - 1, int(high.x)); ++x) {
            const glm::vec2 c(float(x) + 0.5f, float(y) + 0.5f);
            const float a = cross2(p[1] - c, p[2] - c) / area, b = cross2(p[2] - c, p[0] - c) / area;
            constexpr float inside = 1e-3f;
            if (a > inside && b > inside && 1 - a - b > inside) visit(size_t(y) * texture_px + size_t(x));
        }
}

// Calls with the first vertex of each edge that belongs to one triangle alone. Returns the number of edges that two
// triangles use the same way.
template <class Visit>
int for_open_edges(const claque::model::Part &part, Visit visit)
{
    std::map<std::pair<Place, Place>, std::pair<int, uint32_t>> edges;
    for (const auto &t : claque::model::triangles_of(part))
        for (size_t k = 0; k < 3; ++k) {
            auto &[count, vertex] = edges[{place(part, t[k]), place(part, t[(k + 1) % 3])}];
            ++count, vertex = t[k];
        }
    int doubled = 0;
    for (const auto &[edge, found] : edges) {
        doubled += found.first > 1;
        if (edges.count({edge.second, edge.first}) == 0) visit(found.second);
    }
    return doubled;
}

}  // namespace puppet
