#include "lib/asset/areas/triangulate.h"

#include <algorithm>
#include <cmath>

#include "lib/asset/areas/outline.h"

namespace claque::asset
{

namespace
{

// With its edges, and what is nearer to them than 0; the triangle is counter-clockwise.
bool holds(const Point &a, const Point &b, const Point &c, const Point &p, double nearness)
{
    return side(a, b, p) >= nearness && side(b, c, p) >= nearness && side(c, a, p) >= nearness;
}

// Whether a point of the box may be held.
bool may_hold(const Point &a, const Point &b, const Point &c, const Box &box, double nearness)
{
    return box.most_left(a, b) >= nearness && box.most_left(b, c) >= nearness && box.most_left(c, a) >= nearness;
}

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
        std::vector<Box> places;
        for (const Corner &corner : corners_) places.push_back({corner.at, corner.at});
        if (places.size() > 3) places_ = BoxTree(places);  // most polygons of a mesh are triangles
        last_try_.resize(corners_.size());
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
        Box ear = box_of(a, d);
        ear.add(b);
        const auto may_hide = [&](const Box &box) { return box.meets(ear) && may_hold(a, b, d, box, -4 * tiny_); };
        return !places_.any(b, may_hide, [&](uint32_t p) {
            if (p == c || p == corners_[c].before || p == corners_[c].after) return false;
            const Point &at = corners_[p].at;
            // A corner at an end of the cut does not hide it; one at the tip does, if its edges cross the cut.
            if (same(at, a) || same(at, d)) return false;
            if (same(at, b)) return in_angle(c, before(p).at) || in_angle(c, after(p).at);
            return turn(p) <= tiny_ && holds(a, b, d, at, nearness);
        });
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
        if (at_ == c) at_ = corners_[c].after;
        places_.set(c, {});
        last_try_[c] = nowhere;
        try_later(corners_[c].before), try_later(corners_[c].after);
        --left_;
    }

    void try_later(uint32_t c)
    {
        last_try_[c] = static_cast<uint32_t>(tries_.size());
        tries_.push_back(c);
    }

    // Clips ears until there are none but those that a corner hid which has gone.
    void clip_round(double nearness)
    {
        tries_.clear();
        for (uint32_t i = left_, c = at_; i > 0; --i, c = corners_[c].after) try_later(c);
        for (uint32_t i = 0; i < tries_.size() && left_ > 3; ++i) {
            const uint32_t c = tries_[i];
            if (last_try_[c] != i || !is_ear(c, nearness)) continue;
            emit(c);
            const uint32_t back = corners_[c].before;
            drop(c);
            settle(back);
        }
    }

    void emit(uint32_t c)
    {
        for (const uint32_t corner : {corners_[c].before, c, corners_[c].after})
            out_.push_back(first_ + corners_[corner].point);
    }

    uint32_t first_;
    std::vector<uint32_t> &out_;
    BoxTree places_;  // of the corners that are left
    // Corners to be tried. Those with a new neighbour come last: beginning elsewhere gives less slender triangles.
    std::vector<uint32_t> tries_, last_try_;
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
