#include "lib/asset/areas/ring_check.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"

namespace claque::asset
{

namespace
{

// Points that were rounded onto an edge do not cross it.
constexpr double touching_m = 1e-7;

struct Edge {
    Point from, to;
    double low_x() const { return std::min(from.x, to.x); }
    double high_x() const { return std::max(from.x, to.x); }
    double low_y() const { return std::min(from.y, to.y); }
    double high_y() const { return std::max(from.y, to.y); }

    // Distance of a point from the line, positive on the left.
    double distance(const Point &p) const
    {
        const double x = to.x - from.x, y = to.y - from.y;
        return (x * (p.y - from.y) - y * (p.x - from.x)) / std::sqrt(x * x + y * y);
    }
    bool parts(const Edge &other) const
    {
        const double a = distance(other.from), b = distance(other.to);
        return (a > touching_m && b < -touching_m) || (a < -touching_m && b > touching_m);
    }
};

std::vector<Edge> edges_of(const std::vector<Ring> &rings)
{
    std::vector<Edge> edges;
    for (const Ring &ring : rings)
        for (size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    std::sort(edges.begin(), edges.end(), [](const Edge &a, const Edge &b) { return a.low_x() < b.low_x(); });
    return edges;
}

enum class Where { inside, outside, on_edge };

Where where(const Point &p, const Ring &ring)
{
    bool inside = false;
    for (size_t i = 0; i < ring.size(); ++i) {
        const Edge edge{ring[i], ring[(i + 1) % ring.size()]};
        const bool beside = p.x < edge.low_x() - touching_m || p.x > edge.high_x() + touching_m ||
                            p.y < edge.low_y() - touching_m || p.y > edge.high_y() + touching_m;
        if (!beside && std::fabs(edge.distance(p)) <= touching_m) return Where::on_edge;
        const Point &a = edge.from, &b = edge.to;
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y)) inside = !inside;
    }
    return inside ? Where::inside : Where::outside;
}

// Where the first point lies that is not on an edge. Of rings that do not cross, all others lie there, too.
Where where(const Ring &ring, const Ring &other)
{
    for (const Point &point : ring) {
        const Where found = where(point, other);
        if (found != Where::on_edge) return found;
    }
    return Where::on_edge;
}

struct Box {
    explicit Box(const Ring &ring)
    {
        for (const Point &p : ring) {
            low.x = std::min(low.x, p.x), high.x = std::max(high.x, p.x);
            low.y = std::min(low.y, p.y), high.y = std::max(high.y, p.y);
        }
    }
    bool holds(const Box &other) const
    {
        return low.x <= other.low.x && low.y <= other.low.y && high.x >= other.high.x && high.y >= other.high.y;
    }
    Point low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
};

}  // namespace

std::string fault_of(const std::vector<Ring> &rings)
{
    const std::vector<Edge> edges = edges_of(rings);
    for (size_t i = 0; i < edges.size(); ++i)
        for (size_t k = i + 1; k < edges.size() && edges[k].low_x() < edges[i].high_x(); ++k) {
            const Edge &a = edges[i], &b = edges[k];
            if (a.low_y() <= b.high_y() && b.low_y() <= a.high_y() && a.parts(b) && b.parts(a))
                return base::text_of("has edges that cross, from (%g, %g) and from (%g, %g)", a.from.x, a.from.y,
                                     b.from.x, b.from.y);
        }
    std::vector<Box> boxes;
    for (const Ring &ring : rings) boxes.emplace_back(ring);
    for (size_t i = 1; i < rings.size(); ++i) {
        if (where(rings[i], rings[0]) == Where::outside) return base::text_of("has its hole %zu outside", i);
        for (size_t k = 1; k < rings.size(); ++k)
            if (k != i && boxes[k].holds(boxes[i]) && where(rings[i], rings[k]) == Where::inside)
                return base::text_of("has its hole %zu in its hole %zu", i, k);
    }
    return "";
}

}  // namespace claque::asset
