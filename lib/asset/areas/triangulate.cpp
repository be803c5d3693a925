#include "lib/asset/areas/triangulate.h"

#include <algorithm>
#include <cmath>

namespace claque::asset
{

namespace
{

constexpr uint32_t nowhere = 0xffffffffu;

// A corner of the outline that is left. Bridges make two corners of a point.
struct Corner {
    Point at;
    uint32_t point = 0, before = 0, after = 0;
};

// Positive: c lies left of the way from a to b.
double side(const Point &a, const Point &b, const Point &c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool same(const Point &a, const Point &b) { return a.x == b.x && a.y == b.y; }

// With its edges; the triangle is counter-clockwise.
bool holds(const Point &a, const Point &b, const Point &c, const Point &p)
{
    return side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0;
}

class Outline
{
public:
    Outline(const std::vector<Ring> &rings, uint32_t first, std::vector<uint32_t> &out)
        : origin_(rings[0][0]), first_(first), out_(out)
    {
        std::vector<uint32_t> leftmost;
        uint32_t point = 0;
        for (const Ring &ring : rings) {
            const uint32_t start = add_ring(ring, point);
            point += static_cast<uint32_t>(ring.size());
            if (&ring == &rings[0]) at_ = start;
            else leftmost.push_back(start);
        }
        std::stable_sort(leftmost.begin(), leftmost.end(),
                         [&](uint32_t a, uint32_t b) { return corners_[a].at.x < corners_[b].at.x; });
        for (const uint32_t hole : leftmost) bridged_ = bridged_ && join(hole);
    }

    bool clip()
    {
        if (!bridged_) return false;
        drop_flat(at_);
        uint32_t left = count();
        // Corners whose ears may have changed. Clipping an ear changes those of its neighbours alone, but for ties.
        for (int round = 0; left > 3 && round < 8; ++round) {
            const uint32_t before = left;
            left = clip_round(left, round % 2 == 1);
            if (left == before && round % 2 == 1) break;
        }
        if (left == 3 && turn(at_) < 0) return false;
        if (left == 3) emit(at_);
        return left <= 3;
    }

private:
    const Corner &before(uint32_t c) const { return corners_[corners_[c].before]; }
    const Corner &after(uint32_t c) const { return corners_[corners_[c].after]; }
    double turn(uint32_t c) const { return side(before(c).at, corners_[c].at, after(c).at); }

    // Gives the leftmost corner.
    uint32_t add_ring(const Ring &ring, uint32_t point)
    {
        const uint32_t start = static_cast<uint32_t>(corners_.size()), n = static_cast<uint32_t>(ring.size());
        uint32_t leftmost = start;
        for (uint32_t i = 0; i < n; ++i) {
            // Far from the origin of a map, differences keep their digits.
            corners_.push_back({{ring[i].x - origin_.x, ring[i].y - origin_.y},
                                point + i,
                                start + (i + n - 1) % n,
                                start + (i + 1) % n});
            const Point &at = corners_.back().at, &best = corners_[leftmost].at;
            if (at.x < best.x || (at.x == best.x && at.y < best.y)) leftmost = start + i;
        }
        return leftmost;
    }

    uint32_t count() const
    {
        uint32_t n = 1;
        for (uint32_t c = corners_[at_].after; c != at_; c = corners_[c].after) ++n;
        return n;
    }

    // Whether the way to `other` begins inside of the outline.
    bool leads_inside(uint32_t c, const Point &other) const
    {
        const Point &at = corners_[c].at;
        if (turn(c) > 0) return side(at, other, after(c).at) <= 0 && side(at, before(c).at, other) <= 0;
        return side(at, other, before(c).at) > 0 || side(at, after(c).at, other) > 0;
    }

    // The corner at a place from which the way to `onward` leads inside; or another one there; or nowhere.
    uint32_t corner_at(const Point &place, const Point &onward) const
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
    uint32_t bridge_of(uint32_t hole) const
    {
        const Point h = corners_[hole].at;
        if (const uint32_t touched = corner_at(h, after(hole).at); touched != nowhere) return touched;
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
    uint32_t nearest_in_sight(uint32_t best, const Point &h, double reached) const
    {
        const Point m = corners_[best].at, hit{reached, h.y};
        const uint32_t stop = best;
        double least = HUGE_VAL;
        uint32_t c = best;
        do {
            const Point &p = corners_[c].at;
            const bool between = h.x > p.x && p.x >= m.x && (h.y < m.y ? holds(h, m, hit, p) : holds(hit, m, h, p));
            if (between && leads_inside(c, h)) {
                const double slope = std::fabs(h.y - p.y) / (h.x - p.x);
                const Point &b = corners_[best].at;
                if (slope < least || (slope == least && (p.x > b.x || (p.x == b.x && sector_holds(best, c)))))
                    best = c, least = slope;
            }
            c = corners_[c].after;
        } while (c != stop);
        return best;
    }

    // Of two corners at one place: whether the second one's angle lies in the first one's.
    bool sector_holds(uint32_t m, uint32_t p) const
    {
        return side(before(m).at, corners_[m].at, before(p).at) > 0 &&
               side(after(p).at, corners_[m].at, after(m).at) > 0;
    }

    bool join(uint32_t hole)
    {
        const uint32_t bridge = bridge_of(hole);
        if (bridge == nowhere) return false;
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

    void unlink(uint32_t c)
    {
        corners_[corners_[c].before].after = corners_[c].after;
        corners_[corners_[c].after].before = corners_[c].before;
        if (at_ == c) at_ = corners_[c].after;
    }

    // Drops corners on a straight way, and spikes: they enclose nothing.
    void drop_flat(uint32_t from)
    {
        uint32_t c = from, stop = from;
        bool again = true;
        while (again || c != stop) {
            again = false;
            if (corners_[c].after == corners_[c].before) return;
            if (same(corners_[c].at, after(c).at) || turn(c) == 0) {
                const uint32_t back = corners_[c].before;
                unlink(c);
                c = stop = back;
                again = true;
            } else {
                c = corners_[c].after;
            }
        }
        at_ = c;
    }

    bool is_ear(uint32_t c, bool loosely) const
    {
        const Point &a = before(c).at, &b = corners_[c].at, &d = after(c).at;
        if (!(side(a, b, d) > 0)) return false;
        const double low_x = std::min({a.x, b.x, d.x}), high_x = std::max({a.x, b.x, d.x});
        const double low_y = std::min({a.y, b.y, d.y}), high_y = std::max({a.y, b.y, d.y});
        for (uint32_t p = corners_[corners_[c].after].after; p != corners_[c].before; p = corners_[p].after) {
            const Point &at = corners_[p].at;
            if (at.x < low_x || at.x > high_x || at.y < low_y || at.y > high_y) continue;
            // The other end of a bridge, at a corner of the ear, is in nobody's way.
            if (same(at, a) || (loosely && (same(at, b) || same(at, d)))) continue;
            if (turn(p) <= 0 && holds(a, b, d, at)) return false;
        }
        return true;
    }

    // Clips ears until a whole way round finds none; gives the number of corners left.
    uint32_t clip_round(uint32_t left, bool loosely)
    {
        uint32_t c = at_;
        uint32_t tried = 0;
        std::vector<bool> known(corners_.size());  // not an ear, and no neighbour has changed since
        while (left > 3 && tried < left) {
            if (known[c] || !is_ear(c, loosely)) {
                known[c] = true;
                c = corners_[c].after, ++tried;
                continue;
            }
            emit(c);
            const uint32_t back = corners_[c].before, next = corners_[c].after;
            unlink(c);
            --left, tried = 0;
            known[back] = known[next] = false;
            left -= drop_if_flat(back, known, left);
            // Beginning elsewhere gives less slender triangles.
            c = corners_[next].after;
        }
        at_ = c;
        return left;
    }

    // A corner that clipping has made straight. Gives how many went.
    uint32_t drop_if_flat(uint32_t c, std::vector<bool> &known, uint32_t left)
    {
        uint32_t gone = 0;
        for (int k = 0; k < 2 && left - gone > 3; ++k) {
            const uint32_t next = corners_[c].after;
            if (turn(c) != 0) {
                c = next;
                continue;
            }
            known[corners_[c].before] = known[next] = false;
            unlink(c);
            ++gone;
            c = next;
        }
        return gone;
    }

    void emit(uint32_t c)
    {
        for (const uint32_t corner : {corners_[c].before, c, corners_[c].after})
            out_.push_back(first_ + corners_[corner].point);
    }

    Point origin_;
    uint32_t first_;
    std::vector<uint32_t> &out_;
    std::vector<Corner> corners_;
    uint32_t at_ = 0;
    bool bridged_ = true;
};

}  // namespace

double signed_area(const Ring &ring)
{
    double twice = 0;
    for (size_t i = 1; i + 1 < ring.size(); ++i) twice += side(ring[0], ring[i], ring[i + 1]);
    return twice / 2;
}

bool triangulate(const std::vector<Ring> &rings, uint32_t first, std::vector<uint32_t> &out)
{
    return Outline(rings, first, out).clip();
}

}  // namespace claque::asset
