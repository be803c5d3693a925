#include "surface.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

namespace puppet
{

namespace
{

// Directions that no edge of a figure is parallel to; the ray goes along the first.
const dvec3 ray = glm::normalize(dvec3(0.0137, 0.0071, 1));
const dvec3 across = glm::normalize(glm::cross(ray, dvec3(0.3, 1, 0.2)));
const dvec3 up = glm::cross(ray, across);

dvec3 turned(dvec3 p) { return {glm::dot(p, ray), glm::dot(p, across), glm::dot(p, up)}; }

uint32_t root_of(std::map<uint32_t, uint32_t> &above, uint32_t at)
{
    while (above.try_emplace(at, at).first->second != at) at = above[at];
    return at;
}

}  // namespace

Surface::Surface(const Model &figure, const std::function<bool(size_t vertex)> &own)
{
    const auto &part = figure.parts[0];
    std::map<std::tuple<float, float, float>, uint32_t> places;
    for (uint32_t v = 0; v < part.positions.size(); ++v) {
        const vec3 p = part.positions[v];
        welded_.push_back(places.try_emplace({p.x, p.y, p.z}, v).first->second);
    }
    for (size_t i = 0; i + 2 < part.indices.size(); i += 3) {
        const std::array<uint32_t, 3> t = {welded_[part.indices[i]], welded_[part.indices[i + 1]],
                                           welded_[part.indices[i + 2]]};
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        if (own(t[0]) && own(t[1]) && own(t[2])) triangles_.push_back(t);
    }
    close_holes(figure);
}

void Surface::close_holes(const Model &figure)
{
    std::map<std::pair<uint32_t, uint32_t>, int> edges;  // how often each is used, less its reverse
    for (const auto &t : triangles_)
        for (size_t k = 0; k < 3; ++k) {
            ++edges[{t[k], t[(k + 1) % 3]}];
            --edges[{t[(k + 1) % 3], t[k]}];
        }
    std::map<uint32_t, uint32_t> above;
    for (const auto &[edge, uses] : edges)
        if (uses > 0) above[root_of(above, edge.first)] = root_of(above, edge.second);
    std::map<uint32_t, Hole> holes;
    for (const auto &[point, unused] : std::map<uint32_t, uint32_t>(above))
        holes[root_of(above, point)].rim.push_back(point);
    uint32_t next = static_cast<uint32_t>(figure.parts[0].positions.size());
    for (auto &[root, hole] : holes) hole.centre = next++;
    for (const auto &[edge, uses] : edges)
        for (int i = 0; i < uses; ++i)
            triangles_.push_back({edge.second, edge.first, holes[root_of(above, edge.first)].centre});
    for (auto &[root, hole] : holes) holes_.push_back(std::move(hole));
}

void Surface::pose(const std::vector<vec3> &vertices)
{
    points_.assign(vertices.begin(), vertices.end());
    for (const Hole &hole : holes_) {
        dvec3 sum(0);
        for (const uint32_t v : hole.rim) sum += points_[v] / double(hole.rim.size());
        points_.push_back(sum);
    }
    turned_.clear();
    for (const dvec3 &p : points_) turned_.push_back(turned(p));
}

// How often the surface goes round a point: the triangles that a ray leaves through, less those that it enters through.
int Surface::winding(dvec3 p) const
{
    const dvec3 q = turned(p);
    int count = 0;
    for (const auto &t : triangles_) {
        const dvec3 &a = turned_[t[0]], &b = turned_[t[1]], &c = turned_[t[2]];
        if (std::max({a.x, b.x, c.x}) < q.x || std::max({a.y, b.y, c.y}) < q.y || std::min({a.y, b.y, c.y}) > q.y ||
            std::max({a.z, b.z, c.z}) < q.z || std::min({a.z, b.z, c.z}) > q.z)
            continue;
        const auto side = [&q](const dvec3 &m, const dvec3 &n) {
            return (m.y - q.y) * (n.z - q.z) - (m.z - q.z) * (n.y - q.y);
        };
        const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
        if ((ab > 0) != (bc > 0) || (bc > 0) != (ca > 0)) continue;
        if ((bc * a.x + ca * b.x + ab * c.x) / (ab + bc + ca) > q.x) count += ab > 0 ? 1 : -1;
    }
    return count;
}

dvec3 Surface::nearest(size_t triangle, dvec3 p) const
{
    const auto &t = triangles_[triangle];
    const dvec3 a = points_[t[0]], b = points_[t[1]], c = points_[t[2]], normal = glm::cross(b - a, c - a);
    const double area = glm::dot(normal, normal);
    const auto part = [&](dvec3 m, dvec3 n) { return glm::dot(glm::cross(m - p, n - p), normal); };
    const double u = part(b, c), v = part(c, a), w = part(a, b);
    if (area > 0 && u >= 0 && v >= 0 && w >= 0) return (u * a + v * b + w * c) / (u + v + w);
    dvec3 best = a;
    for (const auto &[m, n] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        const double length = glm::dot(n - m, n - m);
        const double at = length > 0 ? std::clamp(glm::dot(p - m, n - m) / length, 0.0, 1.0) : 0;
        const dvec3 q = m + (n - m) * at;
        if (glm::distance(q, p) < glm::distance(best, p)) best = q;
    }
    return best;
}

double Surface::depth(dvec3 p) const
{
    if (winding(p) <= 0) return 0;
    std::vector<std::pair<double, size_t>> order;
    for (size_t t = 0; t < triangles_.size(); ++t) order.emplace_back(glm::distance(nearest(t, p), p), t);
    std::sort(order.begin(), order.end());
    constexpr double step = 1e-5;
    for (const auto &[distance, t] : order) {
        const dvec3 a = points_[triangles_[t][0]], b = points_[triangles_[t][1]], c = points_[triangles_[t][2]];
        const dvec3 out = glm::cross(b - a, c - a), at = nearest(t, p);
        if (glm::length(out) > 0 && winding(at + glm::normalize(out) * step) <= 0) return distance;
    }
    return 0;
}

}  // namespace puppet
