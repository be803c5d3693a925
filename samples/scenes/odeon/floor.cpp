#include "samples/scenes/odeon/floor.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/odeon/stairs.h"

namespace scenes
{
namespace
{

constexpr double each_deg = 1.0;                            // of an arc
constexpr double strip_from_m = 0.32, strip_to_m = 0.04;    // before the seats of a row
constexpr double half_rise_m = 0.19;                        // less than half of the least rise between rows
constexpr int outline_sides = 20;                           // of the arc round a part of a strip
constexpr double widest_deg = 40;                           // of a part
constexpr double gangway_half_m = 0.26 + floor_radius_m;    // of what the middle of a person may use
constexpr double beside_stone_m = 0.35, outside_m = 15.2;   // outside: how far the ground behind the stage house goes
constexpr double behind_house_m = 2.2, beside_house_m = 2;  // beyond the stage's depth and half width

class Paving
{
public:
    explicit Paving(const Theatre &theatre) : theatre_(theatre) {}

    Floor build()
    {
        ground();
        for (size_t i = 0; i < theatre_.rows.size(); ++i) strip(i);
        for (const Gangway &gangway : theatre_.gangways) stairs(gangway);
        for (const Walkway &walkway : theatre_.walkways) {
            const SeatRow &row = theatre_.rows.front();
            arc(walkway.inner_m - strip_from_m, walkway.outer_m - 0.3, walkway.y_m, row.first_deg + 1,
                row.last_deg - 1);
        }
        return std::move(floor_);
    }

private:
    uint32_t add(double x, double y, double z)
    {
        floor_.vertices.insert(floor_.vertices.end(), {x, y, z});
        return static_cast<uint32_t>(floor_.vertices.size() / 3 - 1);
    }
    uint32_t add(double radius, double y, double angle_deg, int)
    {
        return add(radius * std::sin(angle_deg * radians), y, -radius * std::cos(angle_deg * radians));
    }
    void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d)
    {
        floor_.triangles.insert(floor_.triangles.end(), {a, b, c, a, c, d});
    }
    void rectangle(double x0, double x1, double z00, double z01, double z1)
    {
        quad(add(x0, 0, z00), add(x0, 0, z1), add(x1, 0, z1), add(x1, 0, z01));
    }

    // A ring's part between two angles.
    void arc(double inner, double outer, double y, double first_deg, double last_deg)
    {
        const int count = std::max(1, static_cast<int>((last_deg - first_deg) / each_deg + 0.999));
        for (int i = 0; i < count; ++i) {
            const double a = first_deg + (last_deg - first_deg) * i / count;
            const double b = first_deg + (last_deg - first_deg) * (i + 1) / count;
            quad(add(inner, y, a, 0), add(inner, y, b, 0), add(outer, y, b, 0), add(outer, y, a, 0));
        }
    }

    // The orchestra, the ways between the stage and the ends of the seats, and the ground round the stage house.
    void ground()
    {
        const StageHouse &stage = theatre_.stage;
        const SeatRow &first = theatre_.rows.front(), &last = theatre_.rows.back();
        const double inner = theatre_.orchestra_radius_m - beside_stone_m, front = stage.front_z_m - beside_stone_m;
        arc(0, inner, 0, -90, 90);
        rectangle(-inner, inner, 0, 0, front);
        const double end_deg = std::max(std::abs(first.first_deg), std::abs(first.last_deg));
        const double slope = -std::cos(end_deg * radians) / std::sin(end_deg * radians);
        const double side = stage.half_width_m + beside_house_m, far = last.radius_m + last.depth_m + 2.3;
        const double back = stage.front_z_m + stage.depth_m + behind_house_m;
        for (const int way : {-1, 1}) {
            const auto along = [&](double x0, double x1, double z00, double z01, double z1) {
                if (way > 0) rectangle(x0, x1, z00, z01, z1);
                else rectangle(-x1, -x0, z01, z00, z1);
            };
            const double beside = 1.2 * beside_stone_m + 0.03;
            along(inner, far, inner * slope + beside, far * slope + beside, front);
            along(side, far, front, front, outside_m);
            along(0, side, back, back, outside_m);
        }
    }

    void strip(size_t number)
    {
        const SeatRow &row = theatre_.rows[number];
        const double half_deg = gangway_half_m / (row.radius_m - strip_from_m) / radians;
        for (const Wedge &wedge : wedges_of(theatre_, number)) {
            double first = wedge.first_deg, last = wedge.last_deg;
            // Up to the stairs, which are wider than what one walks on.
            for (const Gangway &gangway : theatre_.gangways) {
                if (number < gangway.first_row || number > gangway.last_row) continue;
                const double wide = gangway.width_m / row.radius_m / radians;
                if (std::abs(gangway.at_deg - first) < wide) first = gangway.at_deg + half_deg;
                if (std::abs(gangway.at_deg - last) < wide) last = gangway.at_deg - half_deg;
            }
            arc(row.radius_m - strip_from_m, row.radius_m - strip_to_m, row.step_y_m, first, last);
            // From the edge of what the middle of a person may use of the stairs: else the ends of rows would be bays
            // in which people who go past are caught.
            const double edge_deg = floor_radius_m / row.radius_m / radians;
            first -= edge_deg, last += edge_deg;
            const int parts = std::max(1, static_cast<int>(std::ceil((last - first) / widest_deg)));
            const double part_deg = (last - first) / parts;
            for (int i = 0; i < parts; ++i) enclose(number, first + i * part_deg, first + (i + 1) * part_deg);
        }
    }

    // The polygon round a strip has the chord between its inner ends, which lies above the rows before it.
    void enclose(size_t number, double first_deg, double last_deg)
    {
        const SeatRow &row = theatre_.rows[number];
        Floor::Strip strip{{}, row.step_y_m - half_rise_m, row.step_y_m + half_rise_m, number};
        const auto corner = [&](double radius, double angle_deg) {
            strip.outline.push_back(radius * std::sin(angle_deg * radians));
            strip.outline.push_back(-radius * std::cos(angle_deg * radians));
        };
        for (int i = 0; i <= outline_sides; ++i)
            corner(row.radius_m, first_deg + (last_deg - first_deg) * i / outline_sides);
        corner(row.radius_m - strip_from_m, last_deg), corner(row.radius_m - strip_from_m, first_deg);
        floor_.strips.push_back(std::move(strip));
    }

    void stairs(const Gangway &gangway)
    {
        const std::vector<Tread> treads = treads_of(theatre_, gangway);
        std::vector<double> radii = {treads.front().from_m};
        for (const Tread &tread : treads) radii.push_back((tread.from_m + tread.to_m) / 2);
        radii.push_back(treads.back().to_m);
        for (size_t i = 0; i + 1 < radii.size(); ++i) {
            uint32_t corners[4];
            for (int k = 0; k < 4; ++k) {
                const double radius = radii[i + (k > 1)];
                const double half_deg = gangway_half_m / radius / radians;
                const double at = gangway.at_deg + (k == 0 || k == 3 ? -half_deg : half_deg);
                corners[k] = add(radius, ramp_y(treads, radius), at, 0);
            }
            quad(corners[0], corners[1], corners[2], corners[3]);
        }
    }

    const Theatre &theatre_;
    Floor floor_;
};

}  // namespace

Floor floor_of(const Theatre &theatre) { return Paving(theatre).build(); }

std::vector<Tread> treads_of(const Theatre &theatre, const Gangway &gangway)
{
    const SeatRow &first = theatre.rows[gangway.first_row];
    const double front = front_of(theatre, gangway.first_row), below = floor_before(theatre, gangway.first_row);
    std::vector<Tread> treads;
    const int steps = climbing_steps(below, first.step_y_m);
    // The level from which one climbs.
    const double foot = front - stair_run_m * (steps - 1);
    treads.push_back({foot - stair_run_m, foot, below});
    for (int k = 1; k < steps; ++k)
        treads.push_back({front - stair_run_m * (steps - k), front - stair_run_m * (steps - k - 1),
                          below + (first.step_y_m - below) * k / steps});
    double from = front;
    for (size_t i = gangway.first_row; i <= gangway.last_row; ++i) {
        const SeatRow &row = theatre.rows[i];
        const double run = row.depth_m / 2;
        if (row.radius_m - run > from + 1e-6) treads.push_back({from, row.radius_m - run, row.step_y_m});
        treads.push_back({row.radius_m - run, row.radius_m, (row.step_y_m + row.seat_y_m) / 2});
        from = row.radius_m;
    }
    const SeatRow &last = theatre.rows[gangway.last_row];
    treads.push_back({from, last.radius_m + last.depth_m, last.seat_y_m});
    return treads;
}

double ramp_y(const std::vector<Tread> &treads, double radius_m)
{
    double before_m = -1e9, before_y = treads.front().y;
    for (const Tread &tread : treads) {
        const double middle = (tread.from_m + tread.to_m) / 2;
        if (radius_m < middle)
            return before_m < -1e8 ? tread.y
                                   : before_y + (tread.y - before_y) * (radius_m - before_m) / (middle - before_m);
        before_m = middle, before_y = tread.y;
    }
    return treads.back().y;
}

std::vector<std::array<double, 3>> entrances_of(const Theatre &theatre)
{
    const double z = theatre.stage.front_z_m + theatre.stage.depth_m + behind_house_m + 1;
    std::vector<std::array<double, 3>> all;
    for (const double share : {-0.85, -0.55, -0.25, 0.25, 0.55, 0.85})
        all.push_back({share * theatre.stage.half_width_m, 0, z});
    return all;
}

}  // namespace scenes
