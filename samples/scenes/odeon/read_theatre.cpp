// [theatre] of a scenario (S1 2: seats on circular layers with a radius and an angle of their own).
#include "samples/scenes/odeon/validate_theatre.h"
#include "samples/scenes/scenario/sections.h"

namespace scenes
{
namespace
{

constexpr Limits radius_m = {1, 200}, height_limits_m = {-50, 100}, turn_deg = {-180, 180};
constexpr Limits row_number = {1, 100};

void read_rows(TomlTable rows, Theatre &theatre)
{
    const uint32_t count = rows.whole("count", row_number);
    const double depth = rows.number("depth_m", {0.7, 3}), rise = rows.number("rise_m", {0.40, 0.46});
    SeatRow row;
    row.at = rows.place();
    row.radius_m = rows.number("radius_m", radius_m);
    row.depth_m = depth;
    row.seat_y_m = rows.number("seat_y_m", height_limits_m);
    const auto [first, last] = rows.pair("sweep_deg", turn_deg);
    if (!(first < last))
        rows.refuse("has a sweep from " + show(first) + " to " + show(last) + " degrees, which is descending",
                    "sweep_deg");
    row.first_deg = first;
    row.last_deg = last;
    rows.renamed("who", "class");
    if (rows.has("class")) row.social_class = rows.text("class");
    rows.done();
    if (theatre.rows.size() + count > row_number.last)
        rows.refuse("would make row " + show(double(theatre.rows.size() + count)) + "; the limit is " +
                    show(row_number.last));
    for (uint32_t i = 0; i < count; ++i) {
        row.step_y_m = row.seat_y_m - rise;
        theatre.rows.push_back(row);
        row.radius_m += depth;
        row.seat_y_m += rise;
    }
}

void read_gangways(TomlTable gangways, Theatre &theatre)
{
    Gangway gangway;
    gangway.at = gangways.place();
    gangway.width_m = gangways.number("width_m", {0.4, 10});
    const auto [first, last] = gangways.pair("rows", {1, double(theatre.rows.size())});
    if (!(first <= last) || first != double(size_t(first)) || last != double(size_t(last)))
        gangways.refuse(
            "goes from row " + show(first) + " to row " + show(last) + "; it needs two whole numbers, the lower first",
            "rows");
    gangway.first_row = static_cast<size_t>(first) - 1;
    gangway.last_row = static_cast<size_t>(last) - 1;
    for (const double at : gangways.numbers("at_deg", turn_deg)) {
        gangway.at_deg = at;
        theatre.gangways.push_back(gangway);
    }
    gangways.done();
}

void read_stage(TomlTable stage, Theatre &theatre)
{
    theatre.stage.front_z_m = stage.number("front_z_m", {0, 200});
    theatre.stage.depth_m = stage.number("depth_m", {0.5, 50});
    theatre.stage.half_width_m = stage.number("half_width_m", {1, 200});
    theatre.stage.floor_y_m = stage.number("floor_y_m", {0, 5});
    theatre.stage.wall_height_m = stage.number("wall_height_m", {0, 60});
    stage.done();
}

void read_walkways(TomlTable &described, Theatre &theatre)
{
    for (TomlTable &one : described.tables("walkways", "[[theatre.walkways]]")) {
        Walkway walkway;
        walkway.inner_m = one.number("inner_m", radius_m);
        walkway.outer_m = one.number("outer_m", radius_m);
        walkway.y_m = one.number("y_m", height_limits_m);
        walkway.at = one.place();
        one.done();
        theatre.walkways.push_back(walkway);
    }
}

}  // namespace

void read_theatre(TomlTable &all, const ScenarioFiles &, Scenario &scenario)
{
    TomlTable described = all.table("theatre", "[theatre]");
    if (scenario.characters.empty())
        described.refuse(
            "is a theatre without a scenario: nothing says who sits in it; it needs at least one "
            "[[characters]], with a name, a character and a count, and rows of that class");
    Theatre theatre;
    TomlTable orchestra = described.table("orchestra", "[theatre.orchestra]"),
              seats = described.table("seats", "[theatre.seats]");
    theatre.orchestra_radius_m = orchestra.number("radius_m", radius_m);
    orchestra.done();
    theatre.seat_width_m = seats.number("width_m", {0.64, 2});
    theatre.facing_noise_deg = seats.number("facing_noise_deg", {0, 20});
    seats.done();
    for (TomlTable &rows : described.tables("rows", "[[theatre.rows]]")) read_rows(rows, theatre);
    if (theatre.rows.empty()) described.refuse("has no seats: it needs at least one [[theatre.rows]]");
    read_walkways(described, theatre);
    for (TomlTable &one : described.tables("gangways", "[[theatre.gangways]]")) read_gangways(one, theatre);
    read_stage(described.table("stage", "[theatre.stage]"), theatre);
    described.done();
    theatre.classes = scenario.characters;
    validate(theatre, described.place());
    scenario.theatre = std::move(theatre);
}

}  // namespace scenes
