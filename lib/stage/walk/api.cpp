// clq_navigation.
#include <algorithm>
#include <cmath>

#include "lib/stage/walk/limits.h"
#include "lib/stage/walk/mesh.h"

using namespace claque;
using walk::Float3;

namespace
{

Float3 local_of(const walk::Mesh &mesh, const double point[3], const char *name)
{
    walk::require(point != nullptr, "a point is NULL");
    for (int k = 0; k < 3; ++k)
        if (!(std::fabs(point[k]) < 1e12)) walk::fail(CLQ_ARGUMENT, "%s is not finite or far away", name);
    return mesh.local(point);
}

// The corners of a way, in world units; their number, also of those for which there is no room.
uint32_t corners_of(const walk::Mesh &mesh, const Float3 &from, const walk::Way &way, uint32_t max_points,
                    double *points, double &length)
{
    std::vector<float> corners(3 * size_t(walk::max_way_polys));
    int count = 0;
    mesh.query->findStraightPath(from.data(), way.end.data(), way.polygons.data(),
                                 static_cast<int>(way.polygons.size()), corners.data(), nullptr, nullptr, &count,
                                 walk::max_way_polys);
    double sum_m = 0;
    for (int i = 0; i < count; ++i) {
        const float *at = corners.data() + 3 * i;
        if (i > 0) {
            const float *b = at - 3;
            sum_m +=
                std::sqrt(double(at[0] - b[0]) * double(at[0] - b[0]) + double(at[1] - b[1]) * double(at[1] - b[1]) +
                          double(at[2] - b[2]) * double(at[2] - b[2]));
        }
        if (static_cast<uint32_t>(i) < max_points) mesh.world(at, points + 3 * size_t(i));
    }
    length = sum_m / mesh.metres_per_unit;
    return static_cast<uint32_t>(count);
}

}  // namespace

extern "C" {

clq_status clq_navigation_create(const clq_navigation_def *def, clq_navigation **out)
{
    return walk::boundary("clq_navigation_create", [&] {
        walk::require(def && out, "def or out is NULL");
        walk::require_size(*def, "clq_navigation_def_init");
        auto made = std::make_unique<clq_navigation>();
        walk::make_mesh(*def, *made);
        *out = made.release();
    });
}

void clq_navigation_destroy(clq_navigation *navigation)
{
    if (navigation && --navigation->holders == 0) delete navigation;
}

clq_status clq_navigation_get_info(const clq_navigation *navigation, clq_navigation_info *out)
{
    return walk::boundary("clq_navigation_get_info", [&] {
        walk::require(navigation && out, "navigation or out is NULL");
        walk::require_size(*out, "clq_navigation_info_init");
        const walk::Mesh &mesh = *navigation;
        out->tile_count = mesh.tiles, out->polygon_count = mesh.polygons;
        out->door_count = static_cast<uint32_t>(mesh.doors.size());
        out->area_m2 = mesh.area_m2, out->bytes = mesh.bytes;
        mesh.world(mesh.min.data(), out->box_min), mesh.world(mesh.max.data(), out->box_max);
    });
}

clq_status clq_navigation_set_door(clq_navigation *navigation, uint32_t door, bool open)
{
    return walk::boundary("clq_navigation_set_door", [&] {
        walk::require(navigation != nullptr, "navigation is NULL");
        const std::lock_guard<std::mutex> lock(navigation->lock);
        walk::set_door(*navigation, door, open);
    });
}

clq_status clq_navigation_get_door(const clq_navigation *navigation, uint32_t door, bool *open)
{
    return walk::boundary("clq_navigation_get_door", [&] {
        walk::require(navigation && open, "navigation or open is NULL");
        const std::lock_guard<std::mutex> lock(navigation->lock);
        if (door >= navigation->doors.size())
            walk::fail(CLQ_ARGUMENT, "door %u of %zu does not exist", door, navigation->doors.size());
        *open = navigation->doors[door].open;
    });
}

clq_status clq_navigation_find_nearest(const clq_navigation *navigation, const double point[3], double reach,
                                       double out[3], bool *found)
{
    return walk::boundary("clq_navigation_find_nearest", [&] {
        walk::require(navigation && out && found, "navigation, out or found is NULL");
        const walk::Mesh &mesh = *navigation;
        const Float3 local = local_of(mesh, point, "the point");
        const double reach_m = reach * mesh.metres_per_unit;
        if (!(reach_m > 0 && reach_m < 1e6)) walk::fail(CLQ_ARGUMENT, "reach is %g: more than 0 is wanted", reach);
        const std::lock_guard<std::mutex> lock(mesh.lock);
        Float3 place{};
        *found = walk::nearest(mesh, local, static_cast<float>(reach_m), mesh.open, place) != 0;
        if (*found) mesh.world(place.data(), out);
    });
}

clq_status clq_navigation_find_way(const clq_navigation *navigation, const double from[3], const double to[3],
                                   uint32_t max_points, double *points, clq_way *out)
{
    return walk::boundary("clq_navigation_find_way", [&] {
        walk::require(navigation && out, "navigation or out is NULL");
        walk::require_size(*out, "clq_way_init");
        walk::require_range("max_points", max_points, 0, walk::max_way_polys);
        walk::require(points || max_points == 0, "points is NULL");
        const walk::Mesh &mesh = *navigation;
        const Float3 a = local_of(mesh, from, "from"), b = local_of(mesh, to, "to");
        const std::lock_guard<std::mutex> lock(mesh.lock);
        Float3 begin{}, end{};
        const dtPolyRef first = walk::nearest(mesh, a, walk::find_reach_m, mesh.open, begin);
        const dtPolyRef last = walk::nearest(mesh, b, walk::find_reach_m, mesh.open, end);
        clq_way found = clq_way_init();
        walk::Way way;
        if (first && last) walk::find_way(mesh, first, begin, last, end, walk::filter_of_way(mesh, first, last), way);
        if (!way.polygons.empty()) found.point_count = corners_of(mesh, begin, way, max_points, points, found.length);
        found.complete = way.complete;
        *out = found;
    });
}

}  // extern "C"
