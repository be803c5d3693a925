// The outline of a polygon as one ring: its holes are joined with the outside.
#pragma once

#include "lib/asset/areas/box_tree.h"

namespace claque::asset
{

class Outline
{
public:
    explicit Outline(const std::vector<Ring> &rings);

protected:
    static constexpr uint32_t nowhere = 0xffffffffu;

    // Bridges make more corners of a point; the first one has its number.
    struct Corner {
        Point at;
        uint32_t point = 0, before = 0, after = 0, next_of_point = nowhere;
    };

    const Corner &before(uint32_t c) const { return corners_[corners_[c].before]; }
    const Corner &after(uint32_t c) const { return corners_[corners_[c].after]; }
    double turn(uint32_t c) const { return side(before(c).at, corners_[c].at, after(c).at); }

    std::vector<Corner> corners_;
    uint32_t at_ = 0;  // one of the outline
    double tiny_ = 0;  // a turn up to this one is rounding: corners on a straight way of a building that was turned
    bool joined_ = true;

private:
    // An edge of a ring, before bridges. The inside is on its left.
    struct Edge {
        Point from, to;
        double left_of_it(const Point &p) const { return side(from, to, p); }
        const Point &left() const { return before_in_x(from, to) ? from : to; }
        const Point &right() const { return before_in_x(from, to) ? to : from; }
        double y_at(double x) const;
        // Halfway between x and where the second of them begins.
        bool lies_below(const Edge &other, double x) const;
    };

    uint32_t add_ring(const Ring &ring);
    void take_ring(uint32_t first);
    double depth(uint32_t c, const Point &other) const;
    double angle(uint32_t c) const;
    uint32_t corner_at(const Point &place, const Point &onward) const;
    uint32_t bridge_of(uint32_t hole) const;
    uint32_t nearest_between(const Edge &floor, const Edge &ceiling, const Point &h) const;
    bool join_where_it_touches(uint32_t hole);
    bool join(uint32_t hole, uint32_t bridge);

    Point origin_;
    std::vector<Edge> edges_;         // that begin at the points
    BoxTree edge_tree_, point_tree_;  // of the rings that are joined
    double size_ = 0;                 // the largest coordinate, from the origin
    double far_ = 0;                  // the same on the map
};

}  // namespace claque::asset
