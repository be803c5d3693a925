// What is asked of the ground: doors, places, ways.
#include <algorithm>
#include <cmath>
#include <new>

#include "lib/stage/walk/mesh.h"

namespace claque::walk
{

namespace
{

double area_of(const dtMeshTile &tile, const dtPoly &polygon)
{
    double sum = 0;
    const auto at = [&](int i) { return tile.verts + 3 * polygon.verts[i % polygon.vertCount]; };
    for (int i = 0; i < polygon.vertCount; ++i)
        sum += double(at(i)[0]) * double(at(i + 1)[2]) - double(at(i + 1)[0]) * double(at(i)[2]);
    return std::fabs(sum) / 2;
}

}  // namespace

void find_doors(size_t count, Mesh &out)
{
    out.doors.resize(count);
    const dtNavMesh &nav = *out.nav;
    for (int t = 0; t < nav.getMaxTiles(); ++t) {
        const dtMeshTile *tile = nav.getTile(t);
        if (!tile || !tile->header) continue;
        for (int p = 0; p < tile->header->polyCount; ++p) {
            const dtPoly &polygon = tile->polys[p];
            out.area_m2 += area_of(*tile, polygon);
            const unsigned char area = polygon.getArea();
            if (area > 0 && area <= count)
                out.doors[area - 1u].polygons.push_back(nav.getPolyRefBase(tile) | static_cast<dtPolyRef>(p));
        }
    }
    for (size_t i = 0; i < count; ++i)
        if (out.doors[i].polygons.empty())
            fail(CLQ_ARGUMENT, "door %zu lies on no ground: walkable ground begins radius_m away from walls", i);
}

unsigned short flags_of(const Mesh &mesh, dtPolyRef polygon)
{
    unsigned short flags = 0;
    mesh.nav->getPolyFlags(polygon, &flags);
    return flags;
}

dtQueryFilter filter_of_way(const Mesh &mesh, dtPolyRef from_ref, dtPolyRef to_ref)
{
    dtQueryFilter filter = mesh.open;
    const unsigned ends = flags_of(mesh, from_ref) | flags_of(mesh, to_ref);
    filter.setIncludeFlags(static_cast<unsigned short>(walk_flag | (ends & byway_flags)));
    return filter;
}

void set_door(Mesh &mesh, uint32_t door, bool open)
{
    if (door >= mesh.doors.size()) fail(CLQ_ARGUMENT, "door %u of %zu does not exist", door, mesh.doors.size());
    if (mesh.doors[door].open == open) return;
    mesh.doors[door].open = open;
    for (const dtPolyRef polygon : mesh.doors[door].polygons)
        mesh.nav->setPolyFlags(polygon, open ? walk_flag : static_cast<unsigned short>(walk_flag | closed_flag));
    ++mesh.version;
}

dtPolyRef nearest(const Mesh &mesh, const Float3 &point, float reach, const dtQueryFilter &filter, Float3 &out)
{
    const float extents[3] = {reach, reach, reach};
    dtPolyRef found = 0;
    Float3 place{};
    if (dtStatusFailed(mesh.query->findNearestPoly(point.data(), extents, &filter, &found, place.data())) || !found)
        return 0;
    float distance = 0;
    for (size_t k = 0; k < 3; ++k) distance += (place[k] - point[k]) * (place[k] - point[k]);
    if (!(distance <= reach * reach)) return 0;
    out = place;
    return found;
}

void find_way(const Mesh &mesh, dtPolyRef from_ref, const Float3 &from, dtPolyRef to_ref, const Float3 &to,
              const dtQueryFilter &filter, Way &out)
{
    out.polygons.resize(max_way_polys);
    int count = 0;
    const dtStatus status = mesh.query->findPath(from_ref, to_ref, from.data(), to.data(), &filter, out.polygons.data(),
                                                 &count, max_way_polys);
    if (dtStatusDetail(status, DT_OUT_OF_MEMORY)) throw std::bad_alloc();
    if (dtStatusFailed(status)) count = 0;
    out.polygons.resize(static_cast<size_t>(count));
    out.complete = count > 0 && out.polygons.back() == to_ref;
    out.end = to;
    if (count > 0 && !out.complete)
        mesh.query->closestPointOnPoly(out.polygons.back(), to.data(), out.end.data(), nullptr);
}

}  // namespace claque::walk
