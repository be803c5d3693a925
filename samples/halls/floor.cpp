#include "samples/halls/floor.h"

#include "samples/scenes/check.h"

namespace halls
{

void Floor::add(double x0, double z0, double x1, double z1, double y0, double y1)
{
    using Corner = std::array<double, 3>;
    const auto first = static_cast<uint32_t>(vertices.size() / 3);
    for (const Corner &p : {Corner{x0, y0, z0}, Corner{x0, y0, z1}, Corner{x1, y1, z1}, Corner{x1, y1, z0}})
        vertices.insert(vertices.end(), p.begin(), p.end());
    for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) triangles.push_back(first + i);
}

clq_prism Floor::box(double x0, double z0, double x1, double z1)
{
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

OwnNavigation Floor::make() const
{
    const clq_navigation_def wanted = def();
    clq_navigation *made = nullptr;
    scenes::check(clq_navigation_create(&wanted, &made));
    return OwnNavigation(made);
}

}  // namespace halls
