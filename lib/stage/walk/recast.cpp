// From triangles to tiles, by Recast.
#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

#include <DetourNavMeshBuilder.h>
#include <Recast.h>

#include "lib/stage/walk/budget.h"

namespace claque::walk
{

namespace
{

constexpr int reference_bits = 22;  // of a polygon, for tile and polygon together
constexpr unsigned char door_area = 1;

template <class T, void (*release)(T *)>
struct Freed {
    void operator()(T *p) const { release(p); }
};
template <class T, void (*release)(T *)>
using Held = std::unique_ptr<T, Freed<T, release>>;

template <class T, void (*release)(T *)>
Held<T, release> held(T *made)
{
    if (!made) throw std::bad_alloc();
    return Held<T, release>(made);
}

// Keeps what Recast says is wrong.
class Context : public rcContext
{
public:
    Context() : rcContext(true) { enableTimer(false); }
    char text[256] = "";

protected:
    void doLog(const rcLogCategory category, const char *message, const int length) override
    {
        if (category != RC_LOG_ERROR) return;
        const size_t count = std::min(sizeof text - 1, static_cast<size_t>(std::max(length, 0)));
        std::copy(message, message + count, text);
        text[count] = 0;
    }
};

// One tile; Recast's steps in their order. A false is memory or a limit of Recast, of which `context` has the text.
struct Tile {
    Tile(const Ground &of, const rcConfig &with) : ground(of), config(with) {}

    const Ground &ground;
    rcConfig config;
    Context context;
    Held<rcHeightfield, rcFreeHeightField> solid = held<rcHeightfield, rcFreeHeightField>(rcAllocHeightfield());
    Held<rcCompactHeightfield, rcFreeCompactHeightfield> open =
        held<rcCompactHeightfield, rcFreeCompactHeightfield>(rcAllocCompactHeightfield());
    Held<rcContourSet, rcFreeContourSet> contours = held<rcContourSet, rcFreeContourSet>(rcAllocContourSet());
    Held<rcPolyMesh, rcFreePolyMesh> mesh = held<rcPolyMesh, rcFreePolyMesh>(rcAllocPolyMesh());
    Held<rcPolyMeshDetail, rcFreePolyMeshDetail> detail =
        held<rcPolyMeshDetail, rcFreePolyMeshDetail>(rcAllocPolyMeshDetail());

    void demand(bool done) const
    {
        if (!done) fail(CLQ_LIMIT, "Recast could not make a tile to walk on: %s", context.text);
    }
    void rasterise(const std::vector<int> &triangles)
    {
        demand(rcCreateHeightfield(&context, *solid, config.width, config.height, config.bmin, config.bmax, config.cs,
                                   config.ch));
        const int count = static_cast<int>(triangles.size() / 3),
                  vertices = static_cast<int>(ground.vertices.size() / 3);
        std::vector<unsigned char> areas(triangles.size() / 3, 0);
        rcMarkWalkableTriangles(&context, config.walkableSlopeAngle, ground.vertices.data(), vertices, triangles.data(),
                                count, areas.data());
        demand(rcRasterizeTriangles(&context, ground.vertices.data(), vertices, triangles.data(), areas.data(), count,
                                    *solid, config.walkableClimb));
        rcFilterLowHangingWalkableObstacles(&context, config.walkableClimb, *solid);
        // No rcFilterLedgeSpans: it takes a cell from the edge of every area that floats, as files of plans do. The
        // radius keeps people off edges.
        rcFilterWalkableLowHeightSpans(&context, config.walkableHeight, *solid);
    }
    void mark(const Prism &prism, unsigned char area)
    {
        rcMarkConvexPolyArea(&context, prism.points.data(), static_cast<int>(prism.points.size() / 3), prism.min_y,
                             prism.max_y, area, *open);
    }
    void carve()
    {
        demand(rcBuildCompactHeightfield(&context, config.walkableHeight, config.walkableClimb, *solid, *open));
        for (const Prism &hole : ground.holes) mark(hole, RC_NULL_AREA);
        demand(rcErodeWalkableArea(&context, config.walkableRadius, *open));
        for (const Byway &byway : ground.byways)
            mark(byway.prism, static_cast<unsigned char>(door_area + ground.doors.size() + byway.group));
        for (size_t i = 0; i < ground.doors.size(); ++i)
            mark(ground.doors[i], static_cast<unsigned char>(door_area + i));
    }
    // False: there is nothing to walk on.
    bool outline()
    {
        demand(rcBuildDistanceField(&context, *open));
        demand(rcBuildRegions(&context, *open, config.borderSize, config.minRegionArea, config.mergeRegionArea));
        demand(rcBuildContours(&context, *open, config.maxSimplificationError, config.maxEdgeLen, *contours));
        if (contours->nconts == 0) return false;
        demand(rcBuildPolyMesh(&context, *contours, config.maxVertsPerPoly, *mesh));
        if (mesh->npolys == 0) return false;
        demand(rcBuildPolyMeshDetail(&context, *mesh, *open, config.detailSampleDist, config.detailSampleMaxError,
                                     *detail));
        return true;
    }
};

rcConfig config_of(const Ground &ground, const Grid &grid, int column, int row)
{
    rcConfig config{};
    config.cs = ground.cell, config.ch = ground.cell_height;
    config.tileSize = tile_cells, config.borderSize = grid.border;
    config.width = config.height = grid.width;
    config.walkableSlopeAngle = ground.slope_deg;
    config.walkableHeight = static_cast<int>(std::ceil(ground.height / config.ch));
    config.walkableClimb = static_cast<int>(std::floor(ground.step / config.ch + 0.001f));
    config.walkableRadius = static_cast<int>(std::ceil(ground.radius / config.cs - 0.001f));
    config.maxEdgeLen = static_cast<int>(12 / config.cs);
    config.maxSimplificationError = 1;
    config.minRegionArea = static_cast<int>(0.25f / (config.cs * config.cs));  // a quarter of a square metre
    config.mergeRegionArea = 400;
    config.maxVertsPerPoly = 6;
    config.detailSampleDist = std::max(0.9f, 6 * config.cs);
    config.detailSampleMaxError = config.ch;
    const float margin = static_cast<float>(grid.border) * ground.cell;
    config.bmin[0] = ground.min[0] + static_cast<float>(column) * grid.tile_size - margin;
    config.bmin[2] = ground.min[2] + static_cast<float>(row) * grid.tile_size - margin;
    config.bmin[1] = ground.min[1], config.bmax[1] = ground.max[1] + ground.height;
    for (int k = 0; k < 3; k += 2) config.bmax[k] = config.bmin[k] + static_cast<float>(grid.width) * config.cs;
    return config;
}

// Hands a tile to Detour, which owns it then.
void add_tile(Tile &tile, int column, int row, Mesh &out)
{
    rcPolyMesh &mesh = *tile.mesh;
    for (int i = 0; i < mesh.npolys; ++i) {
        if (mesh.areas[i] == RC_WALKABLE_AREA) mesh.areas[i] = 0;
        const size_t first_byway = door_area + tile.ground.doors.size();
        const bool is_byway = mesh.areas[i] >= first_byway;
        mesh.flags[i] = is_byway ? byway_flag(static_cast<uint32_t>(mesh.areas[i] - first_byway)) : walk_flag;
    }
    dtNavMeshCreateParams params{};
    params.verts = mesh.verts, params.vertCount = mesh.nverts;
    params.polys = mesh.polys, params.polyAreas = mesh.areas, params.polyFlags = mesh.flags;
    params.polyCount = mesh.npolys, params.nvp = mesh.nvp;
    params.detailMeshes = tile.detail->meshes;
    params.detailVerts = tile.detail->verts, params.detailVertsCount = tile.detail->nverts;
    params.detailTris = tile.detail->tris, params.detailTriCount = tile.detail->ntris;
    params.walkableHeight = tile.ground.height, params.walkableRadius = tile.ground.radius;
    params.walkableClimb = tile.ground.step;
    params.tileX = column, params.tileY = row;
    std::copy(mesh.bmin, mesh.bmin + 3, params.bmin), std::copy(mesh.bmax, mesh.bmax + 3, params.bmax);
    params.cs = tile.config.cs, params.ch = tile.config.ch, params.buildBvTree = true;
    unsigned char *data = nullptr;
    int size = 0;
    if (!dtCreateNavMeshData(&params, &data, &size)) throw std::bad_alloc();
    if (dtStatusFailed(out.nav->addTile(data, size, DT_TILE_FREE_DATA, 0, nullptr))) {
        dtFree(data);
        fail(CLQ_LIMIT,
             "a tile to walk on has %d polygons, more than a ground of this size can have: smaller scenes "
             "or larger cells help",
             mesh.npolys);
    }
    ++out.tiles, out.polygons += static_cast<uint32_t>(mesh.npolys), out.bytes += static_cast<uint64_t>(size);
}

}  // namespace

void build_tiles(const Ground &ground, Mesh &out)
{
    const Grid grid = grid_of(ground);
    const std::vector<std::vector<int>> tiles = share_out(ground, grid);
    out.nav.reset(dtAllocNavMesh());
    if (!out.nav) throw std::bad_alloc();
    dtNavMeshParams params{};
    std::copy(ground.min.begin(), ground.min.end(), params.orig);
    params.tileWidth = params.tileHeight = grid.tile_size;
    int tile_bits = 0;
    while ((size_t(1) << tile_bits) < tiles.size()) ++tile_bits;
    params.maxTiles = 1 << tile_bits, params.maxPolys = 1 << (reference_bits - std::max(tile_bits, 6));
    if (dtStatusFailed(out.nav->init(&params))) throw std::bad_alloc();
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const std::vector<int> &triangles = tiles[size_t(row) * size_t(grid.columns) + size_t(column)];
            if (triangles.empty()) continue;
            Tile tile(ground, config_of(ground, grid, column, row));
            tile.rasterise(triangles);
            tile.carve();
            if (tile.outline()) add_tile(tile, column, row, out);
        }
    if (out.tiles == 0)
        fail(CLQ_ARGUMENT,
             "of %zu triangles none can be walked on: they are too steep, too low, seen from below, or narrower than "
             "%g m",
             ground.triangles.size() / 3, 2 * double(ground.radius));
    find_doors(ground.doors.size(), out);
    out.query.reset(dtAllocNavMeshQuery());
    if (!out.query || dtStatusFailed(out.query->init(out.nav.get(), max_query_nodes))) throw std::bad_alloc();
}

}  // namespace claque::walk
