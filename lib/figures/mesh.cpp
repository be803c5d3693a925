#include "lib/figures/mesh.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/base/error.h"

namespace claque::figures
{

uint32_t Mesh::add(glm::vec3 position, Region region, Side side)
{
    points.push_back({position, region, side});
    return static_cast<uint32_t>(points.size() - 1);
}

void Mesh::face(Chart chart, Winding winding, Corner a, Corner b, Corner c)
{
    if (a.point == b.point || b.point == c.point || c.point == a.point) return;
    if (winding == Winding::reversed) std::swap(b, c);
    faces.push_back({{a, b, c}, chart});
}

void Mesh::sew(Chart chart, Winding winding, const Chain &lower, const Chain &upper, Along along)
{
    const auto at = [along](const Corner &c) { return along == Along::s ? c.st.x : c.st.y; };
    const auto gap = [this](const Corner &a, const Corner &b) {
        return glm::distance(points[a.point].position, points[b.point].position);
    };
    size_t i = 0, j = 0;
    while (i + 1 < lower.size() || j + 1 < upper.size()) {
        bool lower_next = j + 1 == upper.size();
        if (i + 1 < lower.size() && j + 1 < upper.size()) {
            const float difference = at(lower[i + 1]) - at(upper[j + 1]);
            const bool level = std::fabs(difference) < 1e-4f;
            lower_next = level ? gap(lower[i + 1], upper[j]) <= gap(lower[i], upper[j + 1]) : difference < 0;
        }
        if (lower_next) {
            face(chart, winding, lower[i], lower[i + 1], upper[j]);
            ++i;
        } else {
            face(chart, winding, lower[i], upper[j + 1], upper[j]);
            ++j;
        }
    }
}

void Mesh::fan(Chart chart, Winding winding, const Chain &lower, Corner top)
{
    for (size_t i = 0; i + 1 < lower.size(); ++i) {
        Corner corner = top;
        corner.st.x = top.st.x < 0 ? (lower[i].st.x + lower[i + 1].st.x) / 2 : top.st.x;
        face(chart, winding, lower[i], lower[i + 1], corner);
    }
}

void Mesh::cap(Chart chart, Winding winding, const Chain &loop)
{
    size_t low = 0, high = loop.size() - 1;
    while (high - low > 1) {
        face(chart, winding, loop[low], loop[low + 1], loop[high]);
        ++low;
        if (high - low > 1) {
            face(chart, winding, loop[low], loop[high - 1], loop[high]);
            --high;
        }
    }
}

std::vector<glm::vec3> Mesh::smooth_normals() const
{
    std::vector<glm::vec3> normals(points.size(), glm::vec3(0));
    for (const Face &f : faces) {
        const glm::vec3 p[3] = {points[f.corners[0].point].position, points[f.corners[1].point].position,
                                points[f.corners[2].point].position};
        const glm::vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
        const float length = glm::length(normal);
        if (!(length > 0)) continue;
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 a = glm::normalize(p[(k + 1) % 3] - p[k]), b = glm::normalize(p[(k + 2) % 3] - p[k]);
            // 1 - cos replaces the angle, because inverse trigonometry differs between processors.
            normals[f.corners[k].point] += normal / length * (1 - glm::dot(a, b));
        }
    }
    for (glm::vec3 &n : normals) n = glm::dot(n, n) > 0 ? glm::normalize(n) : glm::vec3(0, 1, 0);
    return normals;
}

Chain ring_chain(const std::vector<uint32_t> &ring, float t)
{
    Chain chain;
    for (size_t i = 0; i <= ring.size(); ++i)
        chain.push_back({ring[i % ring.size()], glm::vec2(static_cast<float>(i) / static_cast<float>(ring.size()), t)});
    return chain;
}

void unwrap(Mesh &mesh, const Layout &layout)
{
    constexpr float gutter = 2;
    std::array<bool, chart_count> placed{};
    for (const auto &[chart, rect] : layout) {
        placed[static_cast<size_t>(chart)] = true;
        glm::vec2 low(1e9f), high(-1e9f);
        for (const Face &f : mesh.faces)
            if (f.chart == chart)
                for (const Corner &corner : f.corners) low = min(low, corner.st), high = max(high, corner.st);
        const glm::vec2 origin(static_cast<float>(rect.x) + gutter, static_cast<float>(rect.y) + gutter);
        const glm::vec2 room(static_cast<float>(rect.width) - 2 * gutter, static_cast<float>(rect.height) - 2 * gutter);
        const float size = static_cast<float>(texture_size);
        for (Face &f : mesh.faces)
            if (f.chart == chart)
                for (Corner &corner : f.corners) {
                    const glm::vec2 local = (corner.st - low) / (high - low);
                    corner.uv = (origin + glm::vec2(local.x, 1 - local.y) * room) / size;
                }
    }
    for (const Face &f : mesh.faces)
        if (!placed[static_cast<size_t>(f.chart)])
            base::fail(CLQ_ARGUMENT, "chart %d has faces and no rectangle in the figure's texture",
                       static_cast<int>(f.chart));
}

}  // namespace claque::figures
