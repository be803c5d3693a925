// [stage], [places] and [navigation]: what agents decide on, and the ground that they walk on.
#include "samples/scenes/scenario/staging.h"

#include <algorithm>

#include "samples/scenes/scenario/sections.h"

namespace scenes
{
namespace
{

constexpr Limits anywhere_m = {-1e6, 1e6};
constexpr size_t most_places = 10000;

}  // namespace

Outline read_outline(TomlTable &table, const char *key)
{
    std::vector<double> numbers = table.numbers(key, anywhere_m);
    if (numbers.size() == 4) {
        const auto [x0, x1] = std::minmax(numbers[0], numbers[2]);
        const auto [z0, z1] = std::minmax(numbers[1], numbers[3]);
        if (!(x1 > x0 && z1 > z0)) table.refuse("has '" + std::string(key) + "' without any width or depth", key);
        return {x0, z0, x0, z1, x1, z1, x1, z0};
    }
    if (numbers.size() < 6 || numbers.size() > 64 || numbers.size() % 2)
        table.refuse("has '" + std::string(key) + "' of " + std::to_string(numbers.size()) +
                         " numbers; it needs 4, a rectangle [x0, z0, x1, z1], or x and z of 3 to 32 corners",
                     key);
    return numbers;
}

void read_staging(TomlTable &all, const ScenarioFiles &files, Scenario &scenario)
{
    TomlTable stage = all.table("stage", "[stage]");
    Staging made;
    made.at = stage.place();
    made.seconds = stage.number("seconds", {0.1, 86400});
    if (stage.has("tick_s")) made.tick_s = stage.number("tick_s", {0.01, 0.2});
    if (stage.has("lead_s")) made.lead_s = stage.number("lead_s", {0, 60});
    if (stage.has("budget")) made.budget = stage.whole("budget", {0, 1e9});
    if (stage.has("budget_us")) made.budget_us = stage.number("budget_us", {0, 1e6});
    if (stage.has("timetable")) {
        made.timetable = file_of(stage, "timetable", files);
        made.timetable_at = stage.place("timetable");
    }
    stage.done();
    if (!all.has("agents")) stage.refuse("has no agents: it needs at least one [[agents]]");
    scenario.stage = std::move(made);
}

Staging &stage_of(TomlTable &all, const char *key, Scenario &scenario)
{
    if (!scenario.stage) all.refuse("has '" + std::string(key) + "', which goes with [stage]", key);
    return *scenario.stage;
}

void read_places(TomlTable &all, const ScenarioFiles &, Scenario &scenario)
{
    Staging &stage = stage_of(all, "places", scenario);
    TomlTable places = all.table("places", "[places]");
    for (const std::string &name : places.names())
        stage.places.push_back({name, places.triple(name, anywhere_m, "[x, y, z]")});
    if (stage.places.size() > most_places)
        places.refuse("has " + std::to_string(stage.places.size()) + " places; at most " + std::to_string(most_places) +
                      " are read");
}

void read_navigation(TomlTable &all, const ScenarioFiles &files, Scenario &scenario)
{
    Staging &stage = stage_of(all, "navigation", scenario);
    TomlTable described = all.table("navigation", "[navigation]");
    ScenarioGround made;
    made.at = described.place();
    if (described.has("area")) {
        made.area = file_of(described, "area", files);
        made.area_at = described.place("area");
    }
    if (described.has("rectangle")) {
        if (!made.area.empty()) described.refuse("has an area and a rectangle; it needs one of the two", "rectangle");
        made.rectangle = read_outline(described, "rectangle");
    }
    if (made.area.empty() && made.rectangle.empty() && !scenario.theatre && !scenario.town)
        described.refuse("does not say where people walk: it needs 'area', a file, or 'rectangle'");
    if (described.has("radius_m")) made.radius_m = described.number("radius_m", {0.05, 5});
    if (described.has("height_m")) made.height_m = described.number("height_m", {0.2, 10});
    if (described.has("max_slope_deg")) made.max_slope_deg = described.number("max_slope_deg", {0, 85});
    if (described.has("max_step_m")) made.max_step_m = described.number("max_step_m", {0, 2});
    if (described.has("cell_m")) made.cell_m = described.number("cell_m", {0.02, 2});
    if (described.has("body_radius_m")) made.body_radius_m = described.number("body_radius_m", {0.1, 2});
    if (described.has("time_gap_s")) made.time_gap_s = described.number("time_gap_s", {0, 5});
    if (described.has("climbing")) made.climbing = described.number("climbing", {0.01, 1});
    if (described.has("descending")) made.descending = described.number("descending", {0.01, 1});
    if (described.has("max_cells")) made.max_cells = described.whole("max_cells", {1, 4e9});
    if (described.has("walls_m")) made.walls_m = described.number("walls_m", {0, 20});
    described.done();
    stage.ground = std::move(made);
}

}  // namespace scenes
