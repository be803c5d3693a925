// Boxes, and on which side of a way points and boxes lie.
#pragma once

#include <algorithm>
#include <cmath>

#include "lib/asset/areas/area.h"

namespace claque::asset
{

// Positive: c lies left of the way from a to b.
inline double side(const Point &a, const Point &b, const Point &c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline bool same(const Point &a, const Point &b) { return a.x == b.x && a.y == b.y; }

// Of points at one x the lower one is further left.
inline bool before_in_x(const Point &a, const Point &b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

struct Box {
    Point low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};  // holds nothing

    void add(const Point &p) { add(Box{p, p}); }
    void add(const Box &other)
    {
        low.x = std::min(low.x, other.low.x), high.x = std::max(high.x, other.high.x);
        low.y = std::min(low.y, other.low.y), high.y = std::max(high.y, other.high.y);
    }
    bool meets(const Box &other) const
    {
        return low.x <= other.high.x && high.x >= other.low.x && low.y <= other.high.y && high.y >= other.low.y;
    }
    bool holds(const Box &other) const
    {
        return low.x <= other.low.x && low.y <= other.low.y && high.x >= other.high.x && high.y >= other.high.y;
    }
    Point middle() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
    // By how much side() of its points differs from that of its middle, at most.
    double spread(const Point &a, const Point &b) const
    {
        return (std::fabs(b.x - a.x) * (high.y - low.y) + std::fabs(b.y - a.y) * (high.x - low.x)) / 2;
    }
    double most_left(const Point &a, const Point &b) const { return side(a, b, middle()) + spread(a, b); }
    double distance(const Point &p) const
    {
        return std::max({low.x - p.x, p.x - high.x, 0.0}) + std::max({low.y - p.y, p.y - high.y, 0.0});
    }
};

inline Box box_of(const Point &a, const Point &b)
{
    Box box{a, a};
    box.add(b);
    return box;
}

}  // namespace claque::asset
