#include "lib/asset/areas/outline.h"

#include <algorithm>
#include <cmath>

namespace claque::asset
{

namespace
{

constexpr uint32_t nowhere = 0xffffffffu;

bool before_in_x(const Point &a, const Point &b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

}  // namespace

Outline::Outline(const std::vector<Ring> &rings) : origin_(rings[0][0])
{
    std::vector<uint32_t> leftmost;
    uint32_t point = 0;
    for (const Ring &ring : rings) {
        const uint32_t start = add_ring(ring, point);
        point += static_cast<uint32_t>(ring.size());
        if (&ring == &rings[0]) at_ = start;
        else leftmost.push_back(start);
    }
    tiny_ = 1e-15 * size_ * size_;
    std::stable_sort(leftmost.begin(), leftmost.end(),
                     [&](uint32_t a, uint32_t b) { return corners_[a].at.x < corners_[b].at.x; });
    places_.reserve(corners_.size());
    for (const Corner &corner : corners_) places_.push_back(corner.at);
    std::sort(places_.begin(), places_.end(), before_in_x);
    for (const uint32_t hole : leftmost)
        joined_ = joined_ && (join_where_it_touches(hole) || join(hole, bridge_of(hole)));
}

// Gives the leftmost corner.
uint32_t Outline::add_ring(const Ring &ring, uint32_t point)
{
    const uint32_t start = static_cast<uint32_t>(corners_.size()), n = static_cast<uint32_t>(ring.size());
    uint32_t leftmost = start;
    for (uint32_t i = 0; i < n; ++i) {
        // Far from the origin of a map, differences keep their digits.
        corners_.push_back(
            {{ring[i].x - origin_.x, ring[i].y - origin_.y}, point + i, start + (i + n - 1) % n, start + (i + 1) % n});
        const Point &at = corners_.back().at, &best = corners_[leftmost].at;
        size_ = std::max({size_, std::fabs(at.x), std::fabs(at.y)});
        if (before_in_x(at, best)) leftmost = start + i;
    }
    return leftmost;
}

// Whether the way to `other` begins inside of the outline.
bool Outline::leads_inside(uint32_t c, const Point &other) const
{
    const Point &at = corners_[c].at;
    if (turn(c) > 0) return side(at, other, after(c).at) <= 0 && side(at, before(c).at, other) <= 0;
    return side(at, other, before(c).at) > 0 || side(at, after(c).at, other) > 0;
}

// The corner at a place from which the way to `onward` leads inside; or another one there; or nowhere.
uint32_t Outline::corner_at(const Point &place, const Point &onward) const
{
    uint32_t found = nowhere, c = at_;
    do {
        if (same(corners_[c].at, place)) {
            if (leads_inside(c, onward)) return c;
            found = c;
        }
        c = corners_[c].after;
    } while (c != at_);
    return found;
}

// The corner that a hole's leftmost corner can be connected with.
uint32_t Outline::bridge_of(uint32_t hole) const
{
    const Point h = corners_[hole].at;
    double reached = -HUGE_VAL;
    uint32_t best = nowhere, c = at_;
    do {
        const Point &a = corners_[c].at, &b = after(c).at;
        // Edges that run down have the inside on their right, where the hole is.
        if (h.y <= a.y && h.y >= b.y && a.y != b.y) {
            const double x = a.x + (h.y - a.y) * (b.x - a.x) / (b.y - a.y);
            if (x <= h.x && x > reached) {
                reached = x;
                best = a.x < b.x ? c : corners_[c].after;
                if (x == h.x) return best;
            }
        }
        c = corners_[c].after;
    } while (c != at_);
    return best == nowhere ? best : nearest_in_sight(best, h, reached);
}

// Corners between the hole, the edge that the ray to the left met, and that edge's end hide the end.
uint32_t Outline::nearest_in_sight(uint32_t best, const Point &h, double reached) const
{
    const Point m = corners_[best].at, hit{reached, h.y};
    const uint32_t stop = best;
    double least = HUGE_VAL;
    uint32_t c = best;
    do {
        const Point &p = corners_[c].at;
        const bool between =
            h.x > p.x && p.x >= m.x && (h.y < m.y ? holds(h, m, hit, p, -tiny_) : holds(hit, m, h, p, -tiny_));
        if (between && leads_inside(c, h)) {
            const double slope = std::fabs(h.y - p.y) / (h.x - p.x);
            const Point &b = corners_[best].at;
            const bool level = std::fabs(slope - least) <= 1e-12;  // the nearer one hides the other
            if (level ? p.x > b.x || (p.x == b.x && sector_holds(best, c)) : slope < least) best = c, least = slope;
        }
        c = corners_[c].after;
    } while (c != stop);
    return best;
}

// Of two corners at one place: whether the second one's angle lies in the first one's.
bool Outline::sector_holds(uint32_t m, uint32_t p) const
{
    return side(before(m).at, corners_[m].at, before(p).at) > 0 && side(after(p).at, corners_[m].at, after(m).at) > 0;
}

// Where rings touch, a bridge beside that place would enclose ground between them.
bool Outline::join_where_it_touches(uint32_t hole)
{
    uint32_t c = hole;
    do {
        const auto [first, last] = std::equal_range(places_.begin(), places_.end(), corners_[c].at, before_in_x);
        if (last - first > 1 && join(c, corner_at(corners_[c].at, after(c).at))) return true;
        c = corners_[c].after;
    } while (c != hole);
    return false;
}

bool Outline::join(uint32_t hole, uint32_t bridge)
{
    if (bridge == nowhere) return false;
    if (same(corners_[hole].at, corners_[bridge].at)) {
        std::swap(corners_[hole].after, corners_[bridge].after);
        corners_[corners_[hole].after].before = hole, corners_[corners_[bridge].after].before = bridge;
        return true;
    }
    // There and back: each end becomes two corners.
    const uint32_t bridge_again = static_cast<uint32_t>(corners_.size()), hole_again = bridge_again + 1;
    corners_.push_back(corners_[bridge]), corners_.push_back(corners_[hole]);
    const uint32_t onward = corners_[bridge].after, around = corners_[hole].before;
    corners_[bridge].after = hole, corners_[hole].before = bridge;
    corners_[bridge_again].after = onward, corners_[onward].before = bridge_again;
    corners_[hole_again].after = bridge_again, corners_[bridge_again].before = hole_again;
    corners_[around].after = hole_again, corners_[hole_again].before = around;
    return true;
}

}  // namespace claque::asset
