// The outline of a polygon as one ring: its holes are joined with the outside.
#pragma once

#include "lib/asset/areas/area.h"

namespace claque::asset
{

// Positive: c lies left of the way from a to b.
inline double side(const Point &a, const Point &b, const Point &c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline bool same(const Point &a, const Point &b) { return a.x == b.x && a.y == b.y; }

// With its edges, and what is nearer to them than 0; the triangle is counter-clockwise.
inline bool holds(const Point &a, const Point &b, const Point &c, const Point &p, double nearness)
{
    return side(a, b, p) >= nearness && side(b, c, p) >= nearness && side(c, a, p) >= nearness;
}

class Outline
{
public:
    explicit Outline(const std::vector<Ring> &rings);

protected:
    // Bridges make two corners of a point.
    struct Corner {
        Point at;
        uint32_t point = 0, before = 0, after = 0;
    };

    const Corner &before(uint32_t c) const { return corners_[corners_[c].before]; }
    const Corner &after(uint32_t c) const { return corners_[corners_[c].after]; }
    double turn(uint32_t c) const { return side(before(c).at, corners_[c].at, after(c).at); }

    std::vector<Corner> corners_;
    uint32_t at_ = 0;  // one of the outline
    double tiny_ = 0;  // a turn up to this one is rounding: corners on a straight way of a building that was turned
    bool joined_ = true;

private:
    uint32_t add_ring(const Ring &ring, uint32_t point);
    bool leads_inside(uint32_t c, const Point &other) const;
    uint32_t corner_at(const Point &place, const Point &onward) const;
    uint32_t bridge_of(uint32_t hole) const;
    uint32_t nearest_in_sight(uint32_t best, const Point &h, double reached) const;
    bool sector_holds(uint32_t m, uint32_t p) const;
    bool join_where_it_touches(uint32_t hole);
    bool join(uint32_t hole, uint32_t bridge);

    Point origin_;
    std::vector<Point> places_;  // of all corners of the rings
    double size_ = 0;
};

}  // namespace claque::asset
