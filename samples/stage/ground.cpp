#include "samples/stage/ground.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "samples/stage/arrivals.h"

namespace staged
{
namespace
{

clq_prism prism_of(const scenes::Outline &outline, double low_m, double high_m)
{
    return {static_cast<uint32_t>(outline.size() / 2), outline.data(), low_m, high_m};
}

// Names the line of the door whose number the library's sentence begins with.
[[noreturn]] void refuse_ground(const scenes::Staging &stage, const std::string &text)
{
    unsigned door = 0;
    const bool of_a_door =
        std::sscanf(text.c_str(), "clq_navigation_create: door %u ", &door) == 1 && door < stage.doors.size();
    throw scenes::Failure((of_a_door ? stage.doors[door].at : stage.ground->at) + ": " + text);
}

void expect_exits_on_ground(const clq_navigation *navigation, const scenes::Staging &stage)
{
    constexpr double reach_m = 2;  // from the end of a way
    for (const scenes::ScenarioAgents &agents : stage.agents)
        for (const size_t exit : agents.exits) {
            const scenes::Place &place = stage.places[exit];
            double on[3];
            bool found = false;
            scenes::check(clq_navigation_find_nearest(navigation, place.position.data(), reach_m, on, &found));
            if (!found) throw scenes::Failure(agents.at + ": no ground is within 2 m of the exit '" + place.name + "'");
        }
}

void expect_agents_on_ground(const Setting &setting, const clq_navigation *navigation, const scenes::Staging &stage)
{
    constexpr uint32_t tries = 10000;
    const IsFree is_free = [](const std::array<double, 3> &, double) { return true; };
    for (const scenes::ScenarioAgents &agents : stage.agents) {
        const OnGround on_ground = [&](std::array<double, 3> &place) {
            return put_on_ground(setting, navigation, agents, place);
        };
        Spot spot;
        uint32_t attempt = 0;
        while (attempt < tries && !find_spot(stage, agents, 1, attempt, on_ground, is_free, spot)) ++attempt;
        if (attempt == tries)
            throw scenes::Failure(agents.at + ": there is no ground where these agents appear (x is east, z is south)");
    }
}

}  // namespace

bool put_on_ground(const Setting &setting, const clq_navigation *navigation, const scenes::ScenarioAgents &agents,
                   std::array<double, 3> &place)
{
    if (agents.from.empty()) place[1] = setting.height_m(place[0], place[2]);
    if (!navigation) return true;
    bool found = false;
    double at[3];
    scenes::check(clq_navigation_find_nearest(navigation, place.data(), 1.0, at, &found));
    if (!found || std::hypot(at[0] - place[0], at[2] - place[2]) > 0.05) return false;
    std::copy(at, at + 3, place.begin());
    return true;
}

OwnNavigation make_navigation(const Setting &setting, const scenes::Staging &stage)
{
    if (!stage.ground) return nullptr;
    Floor floor;
    setting.add_floor(floor);
    std::vector<clq_prism> holes, doors;
    for (const Floor::Obstacle &one : floor.obstacles) holes.push_back(prism_of(one.outline, one.low_m, one.high_m));
    for (const scenes::ScenarioDoor &one : stage.doors) doors.push_back(prism_of(one.outline, one.low_m, one.high_m));
    std::vector<clq_byway> byways;
    for (const Floor::Byway &one : floor.byways)
        byways.push_back({prism_of(one.outline, one.low_m, one.high_m), one.group});
    clq_navigation_def def = clq_navigation_def_init();
    def.vertex_count = static_cast<uint32_t>(floor.vertices.size() / 3), def.vertices = floor.vertices.data();
    def.triangle_count = static_cast<uint32_t>(floor.triangles.size() / 3), def.triangles = floor.triangles.data();
    def.hole_count = static_cast<uint32_t>(holes.size()), def.holes = holes.data();
    def.door_count = static_cast<uint32_t>(doors.size()), def.doors = doors.data();
    def.byway_count = static_cast<uint32_t>(byways.size()), def.byways = byways.data();
    def.radius_m = static_cast<float>(stage.ground->radius_m);
    def.height_m = static_cast<float>(stage.ground->height_m);
    def.max_slope_deg = static_cast<float>(stage.ground->max_slope_deg);
    def.max_step_m = static_cast<float>(stage.ground->max_step_m);
    def.cell_m = static_cast<float>(stage.ground->cell_m);
    def.max_cells = stage.ground->max_cells;
    clq_navigation *made = nullptr;
    if (clq_navigation_create(&def, &made) != CLQ_OK) refuse_ground(stage, clq_last_error());
    OwnNavigation navigation(made);
    expect_exits_on_ground(made, stage);
    expect_agents_on_ground(setting, made, stage);
    for (uint32_t i = 0; i < stage.doors.size(); ++i)
        scenes::check(clq_navigation_set_door(made, i, stage.doors[i].open));
    return navigation;
}

}  // namespace staged
