#include "samples/scenes/town/walkable.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"

namespace scenes::town
{
namespace
{

constexpr double below_m = 3, above_m = 12;  // of prisms, below and above the ground
constexpr double trunk_m = 0.35, fountain_m = 3.95;

class Finder
{
public:
    Finder(const Town &town, double around_m) : town_(town), square_(town.plan().square()), around_m_(around_m) {}

    Walkable find()
    {
        const Terrain &terrain = town_.terrain();
        for (size_t row = 0; row < terrain.rows(); ++row)
            for (size_t column = 0; column < terrain.columns(); ++column)
                if (is_open(column, row)) add_cell(2 * (row * terrain.columns() + column));
        for (const Footprint &one : landmark_footprints(town_.plan(), town_.trade())) add(one);
        for (const Footprint &one : stall_booths(town_.plan(), town_.trade())) out_.booths.push_back(over(one));
        const SquarePlan plan = square_plan(town_.plan());
        add_round(town_.plan().at(plan.fountain_u, plan.fountain_v), fountain_m, 12);
        for (const House &house : town_.houses()) {
            const double along = house.width_m / 2, out = house.depth_m / 2;
            if (is_near(house.at)) add({house.site(), -along, along, -out, out});
        }
        for (const Tree &tree : town_.trees())
            if (is_near(tree.at)) add_round(tree.at, trunk_m, 6);
        return std::move(out_);
    }

private:
    bool is_open(size_t column, size_t row) const
    {
        const Plan &plan = town_.plan();
        const double u = plan.strips_u()[column].middle(), v = plan.strips_v()[row].middle();
        if (u < square_.u0 - around_m_ || u > square_.u1 + around_m_) return false;
        if (v < square_.v0 - around_m_ || v > square_.v1 + around_m_) return false;
        const Cover cover = plan.cover(column, row);
        return cover == Cover::square || cover == Cover::street || cover == Cover::crossing;
    }

    void add_cell(size_t first)
    {
        for (const size_t number : {first, first + 1})
            for (const Vec3 &corner : town_.terrain().triangle(number)) {
                out_.triangles.push_back(static_cast<uint32_t>(out_.vertices.size() / 3));
                for (const float x : {corner.x, corner.y, corner.z}) out_.vertices.push_back(static_cast<double>(x));
            }
    }

    // Houses stand beside the streets; those far away are in no way.
    bool is_near(Point at) const
    {
        const Plan &plan = town_.plan();
        const Point middle = plan.at((square_.u0 + square_.u1) / 2, (square_.v0 + square_.v1) / 2);
        const double reach = around_m_ + 40 + (square_.u1 - square_.u0 + square_.v1 - square_.v0) / 2;
        return std::hypot(at.x - middle.x, at.z - middle.z) < reach;
    }

    void add(const Footprint &one) { out_.obstacles.push_back(over(one)); }

    Walkable::Prism over(const Footprint &one) const
    {
        std::vector<Point> corners;
        for (const auto &[along, out] : {std::pair{one.along0, one.out0}, std::pair{one.along1, one.out0},
                                         std::pair{one.along1, one.out1}, std::pair{one.along0, one.out1}})
            corners.push_back(one.site.ground(along, out));
        return over(corners);
    }

    void add_round(Point middle, double radius, int sides)
    {
        std::vector<Point> corners;
        for (int k = 0; k < sides; ++k) {
            const double angle = two_pi * k / sides;
            corners.push_back({middle.x + radius * std::cos(angle), middle.z + radius * std::sin(angle)});
        }
        out_.obstacles.push_back(over(corners));
    }

    Walkable::Prism over(const std::vector<Point> &corners) const
    {
        Walkable::Prism made{{}, 1e9, -1e9};
        for (const Point &p : corners) {
            made.outline.insert(made.outline.end(), {p.x, p.z});
            made.low_m = std::min(made.low_m, town_.height(p.x, p.z) - below_m);
            made.high_m = std::max(made.high_m, town_.height(p.x, p.z) + above_m);
        }
        return made;
    }

    const Town &town_;
    const Block &square_;
    double around_m_;
    Walkable out_;
};

}  // namespace

Walkable walkable_square(const Town &town, double around_m) { return Finder(town, around_m).find(); }

}  // namespace scenes::town
