#include "lib/asset/areas/triangulate.h"

#include <algorithm>
#include <cmath>

#include "lib/asset/areas/outline.h"

namespace claque::asset
{

namespace
{

class EarClipper : Outline
{
public:
    EarClipper(const std::vector<Ring> &rings, uint32_t first, std::vector<uint32_t> &out)
        : Outline(rings), first_(first), out_(out)
    {
    }

    bool clip()
    {
        if (!joined_) return false;
        known_.resize(corners_.size());
        left_ = static_cast<uint32_t>(corners_.size());
        for (uint32_t i = left_; i > 0; --i) at_ = corners_[settle(at_)].after;
        // A corner that goes may have hidden ears elsewhere, so there is a second round. Points that lie on a cut but
        // for rounding hide it at first, and then no longer.
        for (const double nearness : {-tiny_, -tiny_, tiny_, tiny_}) clip_round(nearness);
        if (left_ > 3 || turn(at_) < -tiny_) return false;
        if (turn(at_) > tiny_) emit(at_);
        return true;
    }

private:
    // On a straight way, or the tip of a spike: it encloses nothing.
    bool is_flat(uint32_t c) const
    {
        return std::fabs(turn(c)) <= tiny_ || same(corners_[c].at, before(c).at) || same(corners_[c].at, after(c).at);
    }

    // Whether the way from a convex corner to `p` begins between its edges.
    bool in_angle(uint32_t c, const Point &p) const
    {
        return side(before(c).at, corners_[c].at, p) > tiny_ && side(corners_[c].at, after(c).at, p) > tiny_;
    }

    bool is_ear(uint32_t c, double nearness) const
    {
        const Point &a = before(c).at, &b = corners_[c].at, &d = after(c).at;
        if (!(side(a, b, d) > tiny_)) return false;
        const double low_x = std::min({a.x, b.x, d.x}), high_x = std::max({a.x, b.x, d.x});
        const double low_y = std::min({a.y, b.y, d.y}), high_y = std::max({a.y, b.y, d.y});
        for (uint32_t p = corners_[corners_[c].after].after; p != corners_[c].before; p = corners_[p].after) {
            const Point &at = corners_[p].at;
            if (at.x < low_x || at.x > high_x || at.y < low_y || at.y > high_y) continue;
            // A corner at an end of the cut does not hide it; one at the tip does, if its edges cross the cut.
            if (same(at, a) || same(at, d)) continue;
            if (same(at, b)) {
                if (in_angle(c, before(p).at) || in_angle(c, after(p).at)) return false;
                continue;
            }
            if (turn(p) <= tiny_ && holds(a, b, d, at, nearness)) return false;
        }
        return true;
    }

    // Drops a corner and its neighbours while they are flat. Gives one that stays.
    uint32_t settle(uint32_t c)
    {
        while (left_ > 3) {
            const uint32_t flat = is_flat(c) ? c : corners_[c].after;
            if (!is_flat(flat)) break;
            c = corners_[flat].before;
            drop(flat);
        }
        return c;
    }

    void drop(uint32_t c)
    {
        corners_[corners_[c].before].after = corners_[c].after;
        corners_[corners_[c].after].before = corners_[c].before;
        known_[corners_[c].before] = known_[corners_[c].after] = false;
        if (at_ == c) at_ = corners_[c].after;
        --left_;
    }

    // Clips ears until a whole way round finds none.
    void clip_round(double nearness)
    {
        known_.assign(corners_.size(), false);
        uint32_t c = at_;
        for (uint32_t tried = 0; left_ > 3 && tried < left_;) {
            if (known_[c] || !is_ear(c, nearness)) {
                known_[c] = true;
                c = corners_[c].after, ++tried;
                continue;
            }
            emit(c);
            const uint32_t back = corners_[c].before;
            drop(c);
            tried = 0;
            // Beginning elsewhere gives less slender triangles.
            c = corners_[corners_[settle(back)].after].after;
        }
        at_ = c;
    }

    void emit(uint32_t c)
    {
        for (const uint32_t corner : {corners_[c].before, c, corners_[c].after})
            out_.push_back(first_ + corners_[corner].point);
    }

    uint32_t first_;
    std::vector<uint32_t> &out_;
    std::vector<bool> known_;  // not an ear, and no neighbour has changed since
    uint32_t left_ = 0;
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
    return EarClipper(rings, first, out).clip();
}

}  // namespace claque::asset
