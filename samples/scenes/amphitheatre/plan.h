// The plan of the Flavian Amphitheatre in Rome (Colosseum), simplified: the measures that are published, and rows,
// stairs and openings between them. docs/amphitheatre.md compares them. Metres; the arena's floor is at y = 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "samples/scenes/amphitheatre/oval.h"

namespace scenes::amphitheatre
{

// Published: the axes of the whole, 188 m by 156 m; of the arena, about 83 m by 48 m (others measured 86 m by 54 m: the
// curves are parallel here, which gives 83 m by 51 m); 80 bays; a height of 48.5 m; a podium of 3.6 m.
constexpr double half_long_m = 94, half_short_m = 78, arena_long_m = 41.5, arena_short_m = 25.5;
constexpr double building_m = half_long_m - arena_long_m;  // from the arena's wall to the outer one
constexpr double height_m = 48.5, podium_m = 3.6;
constexpr int bay_count = 80;

enum class Tier : uint8_t { podium, primum, imum, summum, ligneis };
constexpr size_t tier_count = 5;

// A block of rows between walkways. All rows of a tier are alike.
struct TierPlan {
    Tier tier;
    size_t rows;
    double out_m;    // front edge of the first row's seats
    double depth_m;  // of a row
    double floor_m;  // the level under the feet of the first row
    double rise_m;
    double seat_m;          // along the row
    double stairs_every;    // bays between two stairs
    double stairs_first;    // the bay of the first one
    double stairs_m;        // their width
    double openings_every;  // bays between two openings (vomitoria) in these rows; 0: there are none
    double openings_first;  // the bay of the first one
    size_t opening_row;     // the first row that an opening interrupts
};
constexpr size_t opening_rows = 4;
constexpr double opening_m = 2.2;  // with its parapets

// A walkway (praecinctio) behind each tier, and the wall (balteus) behind it.
struct Walkway {
    double from_m, to_m, level_m, wall_top_m;  // the wall stands at to_m
};

struct Row {
    Tier tier;
    size_t number;  // within its tier, from the arena outwards
    double out_m, depth_m, seat_y_m, step_y_m;
};

// A stretch of a row.
struct Stretch {
    double first, last;  // turns, last > first
};

struct Seat {
    size_t row;
    double turn;
    double x, y, z;  // the middle of its front edge, at the height of the seat
    double step_y;
    double facing_x, facing_z;
};

class Plan
{
public:
    // seat_share: of every seat's width; 1 is the plan's own.
    explicit Plan(double seat_share = 1);

    const Oval &oval() const { return oval_; }
    const std::vector<TierPlan> &tiers() const { return tiers_; }
    const std::vector<Walkway> &walkways() const { return walkways_; }
    const std::vector<Row> &rows() const { return rows_; }

    // The turn of a bay; bay 0 is at the end of the long axis, 20 at that of the short one. Bays are equally wide at
    // the outer wall.
    double turn_of(double bay) const;
    // Stairs and openings that cut through a row, by their middles.
    std::vector<double> stairs_of(size_t row) const;
    std::vector<double> openings_of(size_t row) const;
    // The stretches of a row that have seats, by ascending turn, from turn 0 on.
    std::vector<Stretch> stretches_of(size_t row) const;
    // All seats, row by row.
    std::vector<Seat> seats() const;
    // Whether a row has no seats at a turn because of a box of honour.
    static constexpr double box_half_m = 5.5;

private:
    Oval oval_;
    std::vector<TierPlan> tiers_;
    std::vector<Walkway> walkways_;
    std::vector<Row> rows_;
    double seat_share_;
};

// The plan with enough seats for so many people: seats are narrower where there are more people than seats of the
// plan's own width. Throws Failure for more than 87 000, the number that the Chronography of 354 states.
Plan plan_for(uint32_t people);
constexpr uint32_t most_people = 87000;

}  // namespace scenes::amphitheatre
