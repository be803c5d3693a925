#include "samples/stage/ground.h"

#include <cstdio>

namespace staged
{
namespace
{

clq_prism prism_of(const scenes::Outline &outline, double low_m, double high_m)
{
    return {static_cast<uint32_t>(outline.size() / 2), outline.data(), low_m, high_m};
}

// Of a door whose number the library's sentence begins with, its place is named.
[[noreturn]] void refuse_ground(const scenes::Staging &stage, const std::string &text)
{
    unsigned door = 0;
    const bool of_a_door =
        std::sscanf(text.c_str(), "clq_navigation_create: door %u ", &door) == 1 && door < stage.doors.size();
    throw scenes::Failure((of_a_door ? stage.doors[door].at : stage.ground->at) + ": " + text);
}

void expect_exits_on_ground(const clq_navigation *navigation, const scenes::Staging &stage)
{
    constexpr double reach_m = 2;  // of a way's end
    for (const scenes::ScenarioAgents &agents : stage.agents)
        for (const size_t exit : agents.exits) {
            const scenes::Place &place = stage.places[exit];
            double on[3];
            bool found = false;
            scenes::check(clq_navigation_find_nearest(navigation, place.position.data(), reach_m, on, &found));
            if (!found) throw scenes::Failure(agents.at + ": no ground is within 2 m of the exit '" + place.name + "'");
        }
}

}  // namespace

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
    for (uint32_t i = 0; i < stage.doors.size(); ++i)
        scenes::check(clq_navigation_set_door(made, i, stage.doors[i].open));
    return navigation;
}

}  // namespace staged
