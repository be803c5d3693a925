#include "samples/stage/ground.h"

namespace staged
{
namespace
{

clq_prism prism_of(const scenes::Outline &outline, double low_m, double high_m)
{
    return {static_cast<uint32_t>(outline.size() / 2), outline.data(), low_m, high_m};
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
    scenes::check(clq_navigation_create(&def, &made), stage.ground->at);
    OwnNavigation navigation(made);
    for (uint32_t i = 0; i < stage.doors.size(); ++i)
        scenes::check(clq_navigation_set_door(made, i, stage.doors[i].open));
    return navigation;
}

}  // namespace staged
