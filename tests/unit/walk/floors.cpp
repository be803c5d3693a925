#include "tests/unit/walk/floors.h"

namespace floors
{

void Floor::add(double x0, double z0, double x1, double z1, double y0, double y1)
{
    const auto first = static_cast<uint32_t>(vertices.size() / 3);
    for (const Point &p : {Point{x0, y0, z0}, Point{x0, y0, z1}, Point{x1, y1, z1}, Point{x1, y1, z0}})
        vertices.insert(vertices.end(), p.begin(), p.end());
    for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) triangles.push_back(first + i);
}

clq_prism Floor::box(double x0, double z0, double x1, double z1)
{
    outlines.reserve(64);
    outlines.push_back({x0, z0, x1, z0, x1, z1, x0, z1});
    return {4, outlines.back().data(), -1, 3};
}

void Floor::wall(double x0, double z0, double x1, double z1) { holes.push_back(box(x0, z0, x1, z1)); }
void Floor::door(double x0, double z0, double x1, double z1) { doors.push_back(box(x0, z0, x1, z1)); }

void Floor::byway(double x0, double z0, double x1, double z1, uint32_t group)
{
    byways.push_back({box(x0, z0, x1, z1), group});
}

clq_navigation_def Floor::def() const
{
    clq_navigation_def def = clq_navigation_def_init();
    def.vertices = vertices.data(), def.vertex_count = static_cast<uint32_t>(vertices.size() / 3);
    def.triangles = triangles.data(), def.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
    def.radius_m = radius_m, def.cell_m = cell_m;
    def.holes = holes.data(), def.hole_count = static_cast<uint32_t>(holes.size());
    def.doors = doors.data(), def.door_count = static_cast<uint32_t>(doors.size());
    def.byways = byways.data(), def.byway_count = static_cast<uint32_t>(byways.size());
    return def;
}

clq_navigation *Floor::make() const
{
    const clq_navigation_def wanted = def();
    clq_navigation *made = nullptr;
    EXPECT_EQ(clq_navigation_create(&wanted, &made), CLQ_OK) << clq_last_error();
    return made;
}

Floor two_rooms(bool with_door)
{
    Floor floor;
    floor.outlines.reserve(64);
    floor.add(0, 0, 16.2, 6);
    floor.wall(8, 0, 8.2, 2.4);
    floor.wall(8, 3.6, 8.2, 6);
    if (with_door) floor.door(7.9, 2.4, 8.3, 3.6);
    return floor;
}

clq_walker Held::add(double x, double z, const clq_locomotion *locomotion, float radius_m) const
{
    clq_walker_def def = clq_walker_def_init();
    def.position[0] = x, def.position[2] = z, def.locomotion = locomotion;
    def.radius_m = radius_m;
    clq_walker made = {0, 0};
    EXPECT_EQ(clq_walkers_add(walkers, &def, &made), CLQ_OK) << clq_last_error();
    return made;
}

void Held::go(clq_walker walker, double x, double z, float near_m) const
{
    const double goal[3] = {x, 0, z};
    EXPECT_EQ(clq_walker_go(walkers, walker, goal, near_m, 0), CLQ_OK) << clq_last_error();
}

clq_walker_info Held::info(clq_walker walker) const
{
    clq_walker_info out = clq_walker_info_init();
    EXPECT_EQ(clq_walkers_get_walker(walkers, walker, &out), CLQ_OK) << clq_last_error();
    return out;
}

uint64_t Held::hash() const
{
    clq_walkers_info out = clq_walkers_info_init();
    EXPECT_EQ(clq_walkers_get_info(walkers, &out), CLQ_OK);
    return out.hash;
}

void Held::step(int count) const
{
    for (int i = 0; i < count; ++i) ASSERT_EQ(clq_walkers_step(walkers), CLQ_OK) << clq_last_error();
}

}  // namespace floors
