// Checks what a host gives, and turns it into what Recast takes.
#include <algorithm>
#include <cmath>

#include "lib/stage/walk/mesh.h"

namespace claque::walk
{

namespace
{

constexpr uint32_t max_triangles = 4000000;
constexpr double max_extent_m = 50000;
constexpr double max_height_cells = 8000;  // Recast keeps heights in 13 bits

void check_numbers(const clq_navigation_def &def)
{
    require_range("metres_per_unit", double(def.metres_per_unit), 1e-6, 1e6);
    require_range("radius_m", double(def.radius_m), 0.05, 5);
    require_range("height_m", double(def.height_m), 0.2, 10);
    require_range("max_slope_deg", double(def.max_slope_deg), 0, 85);
    require_range("max_step_m", double(def.max_step_m), 0, 2);
    if (def.cell_m != 0) require_range("cell_m", double(def.cell_m), 0.02, 2);
    require(def.vertex_count > 0 && def.triangle_count > 0, "there are no triangles to walk on");
    require(def.vertices && def.triangles, "vertices or triangles is NULL");
    require(def.hole_count == 0 || def.holes, "holes is NULL");
    require(def.door_count == 0 || def.doors, "doors is NULL");
    if (def.triangle_count > max_triangles || def.vertex_count > 3 * max_triangles)
        fail(CLQ_LIMIT, "%u triangles with %u vertices to walk on: %u triangles are possible", def.triangle_count,
             def.vertex_count, max_triangles);
    require(def.byway_count == 0 || def.byways, "byways is NULL");
    if (def.door_count > max_areas) fail(CLQ_ARGUMENT, "%u doors: %u are possible", def.door_count, max_areas);
    if (def.byway_count > max_triangles) fail(CLQ_LIMIT, "%u byways: %u are possible", def.byway_count, max_triangles);
    for (uint32_t i = 0; i < def.byway_count; ++i) {
        const uint32_t group = def.byways[i].group;
        if (group >= CLQ_BYWAY_GROUPS)
            fail(CLQ_ARGUMENT, "byway %u has group %u: 0 to %d is wanted", i, group, CLQ_BYWAY_GROUPS - 1);
        if (def.door_count + group >= max_areas)
            fail(CLQ_ARGUMENT, "%u doors and byways of group %u: %u doors are possible with it", def.door_count, group,
                 max_areas - 1 - group);
    }
    if (def.hole_count > max_triangles) fail(CLQ_LIMIT, "%u holes: %u are possible", def.hole_count, max_triangles);
}

// The middle of the box, in whole metres, so that local floats are small.
void set_origin(const clq_navigation_def &def, Mesh &out)
{
    double min[3] = {INFINITY, INFINITY, INFINITY}, max[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < def.vertex_count; ++i)
        for (int k = 0; k < 3; ++k) {
            const double x = def.vertices[3 * size_t(i) + size_t(k)] * out.metres_per_unit;
            if (!std::isfinite(x)) fail(CLQ_ARGUMENT, "vertex %u to walk on is not finite", i);
            min[k] = std::min(min[k], x), max[k] = std::max(max[k], x);
        }
    for (int k = 0; k < 3; ++k) {
        if (max[k] - min[k] > max_extent_m)
            fail(CLQ_LIMIT, "the ground to walk on is %g m long: %g m are possible", max[k] - min[k], max_extent_m);
        out.origin_m[k] = std::floor((min[k] + max[k]) / 2);
    }
}

Prism read_prism(const Mesh &mesh, const clq_prism &prism, const char *kind, uint32_t number)
{
    if (prism.point_count < 3 || prism.point_count > 32 || !prism.points)
        fail(CLQ_ARGUMENT, "%s %u has %u points: 3 to 32 are wanted", kind, number, prism.point_count);
    Prism out;
    double turns = 0;
    const auto at = [&](uint32_t i, int k) { return prism.points[2 * (i % prism.point_count) + uint32_t(k)]; };
    for (uint32_t i = 0; i < prism.point_count; ++i) {
        const double point[3] = {at(i, 0), prism.min_y, at(i, 1)};
        const Float3 local = mesh.local(point);
        for (const float x : local)
            if (!(std::fabs(double(x)) <= 2 * max_extent_m))
                fail(CLQ_ARGUMENT, "point %u of %s %u is far away or not finite", i, kind, number);
        out.points.insert(out.points.end(), local.begin(), local.end());
        const double ax = at(i + 1, 0) - at(i, 0), az = at(i + 1, 1) - at(i, 1);
        const double bx = at(i + 2, 0) - at(i + 1, 0), bz = at(i + 2, 1) - at(i + 1, 1), turn = ax * bz - az * bx;
        if (turn * turns < 0) fail(CLQ_ARGUMENT, "%s %u is not convex at point %u", kind, number, i + 1);
        if (turn != 0) turns = turn;
    }
    const double top[3] = {at(0, 0), prism.max_y, at(0, 1)};
    out.min_y = out.points[1], out.max_y = mesh.local(top)[1];
    if (turns == 0 || !(out.max_y > out.min_y)) fail(CLQ_ARGUMENT, "%s %u is flat", kind, number);
    return out;
}

void read_triangles(const clq_navigation_def &def, const Mesh &mesh, Ground &out)
{
    out.vertices.reserve(3 * size_t(def.vertex_count));
    out.min = {INFINITY, INFINITY, INFINITY}, out.max = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < def.vertex_count; ++i) {
        const Float3 local = mesh.local(def.vertices + 3 * size_t(i));
        out.vertices.insert(out.vertices.end(), local.begin(), local.end());
        for (size_t k = 0; k < 3; ++k)
            out.min[k] = std::min(out.min[k], local[k]), out.max[k] = std::max(out.max[k], local[k]);
    }
    out.triangles.reserve(3 * size_t(def.triangle_count));
    for (size_t i = 0; i < 3 * size_t(def.triangle_count); ++i) {
        if (def.triangles[i] >= def.vertex_count)
            fail(CLQ_ARGUMENT, "triangle %zu to walk on names vertex %u of %u", i / 3, def.triangles[i],
                 def.vertex_count);
        out.triangles.push_back(static_cast<int>(def.triangles[i]));
    }
}

}  // namespace

Float3 Mesh::local(const double point[3]) const
{
    Float3 out{};
    for (size_t k = 0; k < 3; ++k) out[k] = static_cast<float>(point[k] * metres_per_unit - origin_m[k]);
    return out;
}

void Mesh::world(const float *local, double out[3]) const
{
    for (int k = 0; k < 3; ++k) out[k] = (double(local[k]) + origin_m[k]) / metres_per_unit;
}

Ground read_ground(const clq_navigation_def &def, Mesh &out)
{
    check_numbers(def);
    out.metres_per_unit = double(def.metres_per_unit);
    set_origin(def, out);
    Ground ground;
    read_triangles(def, out, ground);
    for (uint32_t i = 0; i < def.hole_count; ++i) ground.holes.push_back(read_prism(out, def.holes[i], "hole", i));
    for (uint32_t i = 0; i < def.door_count; ++i) ground.doors.push_back(read_prism(out, def.doors[i], "door", i));
    for (uint32_t i = 0; i < def.byway_count; ++i)
        ground.byways.push_back({read_prism(out, def.byways[i].prism, "byway", i), def.byways[i].group});
    out.has_byways = def.byway_count > 0;
    ground.radius = def.radius_m, ground.height = def.height_m;
    ground.slope_deg = def.max_slope_deg, ground.step = def.max_step_m;
    ground.cell = def.cell_m != 0 ? def.cell_m : def.radius_m / 2;
    ground.cell_height = std::min(ground.cell / 2, 0.1f);
    ground.max_cells = def.max_cells;
    const double cells = double(ground.max[1] - ground.min[1]) / double(ground.cell_height);
    if (cells > max_height_cells)
        fail(CLQ_LIMIT, "the ground to walk on is %g m high: with cells of %g m, %g m are possible",
             double(ground.max[1] - ground.min[1]), double(ground.cell), max_height_cells * double(ground.cell_height));
    out.radius = ground.radius;
    out.min = ground.min, out.max = ground.max;
    return ground;
}

void make_mesh(const clq_navigation_def &def, Mesh &out)
{
    const Ground ground = read_ground(def, out);
    constexpr unsigned short any_ground = walk_flag | byway_flags;
    out.open.setIncludeFlags(any_ground), out.open.setExcludeFlags(closed_flag);
    out.everything.setIncludeFlags(any_ground), out.everything.setExcludeFlags(0);
    build_tiles(ground, out);
}

}  // namespace claque::walk
