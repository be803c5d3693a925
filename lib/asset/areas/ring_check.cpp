#include "lib/asset/areas/ring_check.h"

#include <cmath>
#include <map>

#include "lib/asset/areas/box_tree.h"
#include "lib/base/error.h"

namespace claque::asset
{

namespace
{

// Points that were rounded onto an edge do not cross it.
constexpr double touching_m = 1e-7;

struct Edge {
    Point from, to;

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
    // Whether a box has points on both sides of the line.
    bool may_part(const Box &box) const { return std::fabs(side(from, to, box.middle())) <= box.spread(from, to); }
    Box box() const { return box_of(from, to); }
};

void add_edges(const Ring &ring, std::vector<Edge> &edges)
{
    for (size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

std::string crossing(const std::vector<Ring> &rings)
{
    std::vector<Edge> edges;
    for (const Ring &ring : rings) add_edges(ring, edges);
    if (edges.size() < 4) return "";
    std::vector<Point> middles;
    for (const Edge &edge : edges) middles.push_back(edge.box().middle());
    BoxTree before(middles);
    for (uint32_t i = 0; i < edges.size(); ++i) {
        const Edge &a = edges[i], *other = nullptr;
        const Box box = a.box();
        before.any(
            middles[i], [&](const Box &around) { return around.meets(box) && a.may_part(around); },
            [&](uint32_t k) {
                if (a.parts(edges[k]) && edges[k].parts(a)) other = &edges[k];
                return other != nullptr;
            });
        if (other)
            return base::text_of("has edges that cross, from (%g, %g) and from (%g, %g)", other->from.x, other->from.y,
                                 a.from.x, a.from.y);
        before.set(i, box);
    }
    return "";
}

enum class Where { inside, outside, on_edge };

class RingEdges
{
public:
    explicit RingEdges(const Ring &ring)
    {
        add_edges(ring, edges_);
        std::vector<Box> boxes;
        for (const Edge &edge : edges_) boxes.push_back(edge.box());
        tree_ = BoxTree(boxes);
    }

    Where where(const Point &p) const
    {
        const Box near{{p.x - touching_m, p.y - touching_m}, {p.x + touching_m, p.y + touching_m}};
        if (tree_.any(
                p, [&](const Box &box) { return box.meets(near); },
                [&](uint32_t i) { return std::fabs(edges_[i].distance(p)) <= touching_m; }))
            return Where::on_edge;
        bool inside = false;
        tree_.any(
            p,
            [&](const Box &box) {
                return box.meets({p, {HUGE_VAL, p.y}});
            },
            [&](uint32_t i) {
                const Point &a = edges_[i].from, &b = edges_[i].to;
                if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y)) inside = !inside;
                return false;
            });
        return inside ? Where::inside : Where::outside;
    }

private:
    std::vector<Edge> edges_;
    BoxTree tree_;
};

// Where the first point lies that is not on an edge. Of rings that do not cross, all others lie there, too.
Where where(const Ring &ring, const RingEdges &other)
{
    for (const Point &point : ring) {
        const Where found = other.where(point);
        if (found != Where::on_edge) return found;
    }
    return Where::on_edge;
}

std::string misplaced_hole(const std::vector<Ring> &rings)
{
    std::vector<Box> boxes(rings.size());
    for (size_t i = 0; i < rings.size(); ++i)
        for (const Point &p : rings[i]) boxes[i].add(p);
    const BoxTree tree(boxes);
    std::map<uint32_t, RingEdges> edges;  // of rings that another one may lie in
    const auto lies = [&](uint32_t i, uint32_t k) {
        return where(rings[i], edges.try_emplace(k, rings[k]).first->second);
    };
    for (uint32_t i = 1; i < rings.size(); ++i) {
        if (lies(i, 0) == Where::outside) return base::text_of("has its hole %u outside", i);
        uint32_t holder = 0;
        tree.any(
            boxes[i].low, [&](const Box &box) { return box.holds(boxes[i]); },
            [&](uint32_t k) {
                if (k > 0 && k != i && lies(i, k) == Where::inside) holder = k;
                return holder > 0;
            });
        if (holder > 0) return base::text_of("has its hole %u in its hole %u", i, holder);
    }
    return "";
}

}  // namespace

std::string fault_of(const std::vector<Ring> &rings)
{
    const std::string fault = crossing(rings);
    return fault.empty() && rings.size() > 1 ? misplaced_hole(rings) : fault;
}

}  // namespace claque::asset
