#include "lib/asset/areas/outline.h"

#include <algorithm>
#include <cmath>

#include "lib/math/trig.h"

namespace claque::asset
{

double Outline::Edge::y_at(double x) const
{
    return from.x == to.x ? left().y : from.y + (x - from.x) * (to.y - from.y) / (to.x - from.x);
}

// Edges may touch at either end of what they have in common, but for rounding.
bool Outline::Edge::lies_below(const Edge &other, double x) const
{
    const double first_x = std::max(left().x, other.left().x);
    return y_at(first_x) + y_at(x) < other.y_at(first_x) + other.y_at(x);
}

Outline::Outline(const std::vector<Ring> &rings) : origin_(rings[0][0])
{
    std::vector<uint32_t> leftmost;
    for (const Ring &ring : rings) {
        const uint32_t start = add_ring(ring);
        if (&ring == &rings[0]) at_ = start;
        else leftmost.push_back(start);
    }
    // Far from the origin of a map, points are rounded by more than the room's own digits.
    tiny_ = std::max(1e-15 * size_, 4e-16 * far_) * size_;
    if (leftmost.empty()) return;
    std::stable_sort(leftmost.begin(), leftmost.end(),
                     [&](uint32_t a, uint32_t b) { return before_in_x(corners_[a].at, corners_[b].at); });
    std::vector<Point> places, middles;
    for (uint32_t c = 0; c < corners_.size(); ++c) {
        edges_.push_back({corners_[c].at, after(c).at});
        places.push_back(corners_[c].at);
        middles.push_back(box_of(corners_[c].at, after(c).at).middle());
    }
    point_tree_ = BoxTree(places), edge_tree_ = BoxTree(middles);
    take_ring(at_);
    for (const uint32_t hole : leftmost)
        joined_ = joined_ && (join_where_it_touches(hole) || join(hole, bridge_of(hole)));
}

// Gives the leftmost corner.
uint32_t Outline::add_ring(const Ring &ring)
{
    const uint32_t start = static_cast<uint32_t>(corners_.size()), n = static_cast<uint32_t>(ring.size());
    uint32_t leftmost = start;
    for (uint32_t i = 0; i < n; ++i) {
        // Products of differences round less than those of a map's coordinates.
        corners_.push_back(
            {{ring[i].x - origin_.x, ring[i].y - origin_.y}, start + i, start + (i + n - 1) % n, start + (i + 1) % n});
        const Point &at = corners_.back().at, &best = corners_[leftmost].at;
        size_ = std::max({size_, std::fabs(at.x), std::fabs(at.y)});
        far_ = std::max({far_, std::fabs(ring[i].x), std::fabs(ring[i].y)});
        if (before_in_x(at, best)) leftmost = start + i;
    }
    return leftmost;
}

// From now on it is a part of the outline.
void Outline::take_ring(uint32_t first)
{
    uint32_t c = first;
    do {
        point_tree_.set(c, box_of(edges_[c].from, edges_[c].from));
        edge_tree_.set(c, box_of(edges_[c].from, edges_[c].to));
        c = corners_[c].after;
    } while (c != first);
}

// How far the way to `other` begins inside of the outline; negative: outside.
double Outline::depth(uint32_t c, const Point &other) const
{
    const Point &a = before(c).at, &b = corners_[c].at, &d = after(c).at;
    // A tip has the inside all round it or nowhere, which nothing near it tells.
    if (std::fabs(turn(c)) <= tiny_ && (a.x - b.x) * (d.x - b.x) + (a.y - b.y) * (d.y - b.y) > 0) return -2 * tiny_;
    const double from_after = side(b, d, other), from_before = side(b, other, a);
    return turn(c) > 0 ? std::min(from_after, from_before) : std::max(from_after, from_before);
}

// How far a corner is open to the inside, from 0 to a whole turn.
double Outline::angle(uint32_t c) const
{
    const Point &a = before(c).at, &b = corners_[c].at, &d = after(c).at;
    const double found = math::atan2(turn(c), (a.x - b.x) * (d.x - b.x) + (a.y - b.y) * (d.y - b.y));
    return found < 0 ? found + 2 * math::pi : found;
}

// The corner at a place from which the way to `onward` leads inside. Of more such corners it is the narrowest, which
// lies in the others. Without any it is the one that misses the way by least. Nowhere: no corner is there.
uint32_t Outline::corner_at(const Point &place, const Point &onward) const
{
    uint32_t found = nowhere;
    double deepest = -HUGE_VAL;
    const auto is_there = [&](const Box &box) { return box.holds(box_of(place, place)); };
    point_tree_.any(place, is_there, [&](uint32_t point) {
        for (uint32_t c = point; c != nowhere; c = corners_[c].next_of_point) {
            const double deep = std::min(depth(c, onward), -tiny_);
            if (deep > deepest || (deep == deepest && angle(c) < angle(found))) found = c, deepest = deep;
        }
        return false;
    });
    return found;
}

// The corner that a hole's leftmost corner can be connected with. Between the edges below and above it, and right of
// the last corner between these, is nothing (de Berg et al., "Computational Geometry", 3.2). Of corners at one x the
// lower one counts as further left.
uint32_t Outline::bridge_of(uint32_t hole) const
{
    const Point h = corners_[hole].at;
    const Edge *floor = nullptr, *ceiling = nullptr;
    double floor_y = -HUGE_VAL, ceiling_y = HUGE_VAL;
    const double slack = 4 * tiny_ / size_;
    const auto meets = [&](const Box &box) {
        return before_in_x(box.low, h) && before_in_x(h, box.high) && box.high.y >= floor_y - slack &&
               box.low.y <= ceiling_y + slack;
    };
    edge_tree_.any(h, meets, [&](uint32_t point) {
        const Edge &edge = edges_[point];
        const bool is_floor = before_in_x(edge.from, edge.to);
        if (!before_in_x(edge.left(), h) || !before_in_x(h, edge.right()) || edge.left_of_it(h) < -tiny_) return false;
        if (is_floor && (!floor || floor->lies_below(edge, h.x))) floor = &edge, floor_y = edge.y_at(h.x);
        if (!is_floor && (!ceiling || edge.lies_below(*ceiling, h.x))) ceiling = &edge, ceiling_y = edge.y_at(h.x);
        return false;
    });
    return floor && ceiling ? nearest_between(*floor, *ceiling, h) : nowhere;
}

// The last corner left of the hole.
uint32_t Outline::nearest_between(const Edge &floor, const Edge &ceiling, const Point &h) const
{
    Point best{-HUGE_VAL, 0};
    const auto may_be_nearer = [&](const Box &box) {
        return before_in_x(box.low, h) && !before_in_x(box.high, best) &&
               box.most_left(floor.from, floor.to) >= -4 * tiny_ &&
               box.most_left(ceiling.from, ceiling.to) >= -4 * tiny_;
    };
    point_tree_.any(h, may_be_nearer, [&](uint32_t point) {
        const Point &p = edges_[point].from;
        if (before_in_x(p, h) && before_in_x(best, p) && floor.left_of_it(p) >= -tiny_ &&
            ceiling.left_of_it(p) >= -tiny_)
            best = p;
        return false;
    });
    return corner_at(best, h);
}

// Where rings touch, a bridge beside that place would enclose ground between them.
bool Outline::join_where_it_touches(uint32_t hole)
{
    uint32_t c = hole;
    do {
        if (join(c, corner_at(corners_[c].at, after(c).at))) return true;
        c = corners_[c].after;
    } while (c != hole);
    return false;
}

bool Outline::join(uint32_t hole, uint32_t bridge)
{
    if (bridge == nowhere) return false;
    take_ring(hole);
    if (same(corners_[hole].at, corners_[bridge].at)) {
        std::swap(corners_[hole].after, corners_[bridge].after);
        corners_[corners_[hole].after].before = hole, corners_[corners_[bridge].after].before = bridge;
        return true;
    }
    // There and back: each end becomes two corners.
    const uint32_t bridge_again = static_cast<uint32_t>(corners_.size()), hole_again = bridge_again + 1;
    corners_.push_back(corners_[bridge]), corners_.push_back(corners_[hole]);
    corners_[bridge].next_of_point = bridge_again, corners_[hole].next_of_point = hole_again;
    const uint32_t onward = corners_[bridge].after, around = corners_[hole].before;
    corners_[bridge].after = hole, corners_[hole].before = bridge;
    corners_[bridge_again].after = onward, corners_[onward].before = bridge_again;
    corners_[hole_again].after = bridge_again, corners_[bridge_again].before = hole_again;
    corners_[around].after = hole_again, corners_[hole_again].before = around;
    return true;
}

}  // namespace claque::asset
