// The ground on which people can walk: a navigation mesh of Detour in tiles, and its doors. In the mesh places are
// floats in metres from an origin in its middle.
#pragma once

#include <claque/navigation.h>

#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <vector>

#include <DetourNavMesh.h>
#include <DetourNavMeshQuery.h>

#include "lib/stage/walk/limits.h"

namespace claque::walk
{

using Float3 = std::array<float, 3>;

// Not hypot, which asks for a newer C library.
inline float length_of(float x, float z) { return std::sqrt(x * x + z * z); }

constexpr int max_query_nodes = 8192;
constexpr int max_way_polys = 256;
constexpr float find_reach_m = 2;
// Flags of polygons.
constexpr unsigned short walk_flag = 1, closed_flag = 2, first_byway_flag = 4;
constexpr unsigned short byway_flags = first_byway_flag * ((1u << CLQ_BYWAY_GROUPS) - 1);
// Areas of polygons: 0, then doors, then groups of byways. Recast keeps areas in 6 bits, of which it takes two values.
constexpr uint32_t max_areas = 62;

inline unsigned short byway_flag(uint32_t group) { return static_cast<unsigned short>(first_byway_flag << group); }

struct Prism {
    std::vector<float> points;  // xyz, as Recast takes them
    float min_y = 0, max_y = 0;
};

struct Byway {
    Prism prism;
    uint32_t group = 0;
};

struct Door {
    std::vector<dtPolyRef> polygons;
    bool open = true;
};

struct FreeNavMesh {
    void operator()(dtNavMesh *mesh) const { dtFreeNavMesh(mesh); }
};
struct FreeQuery {
    void operator()(dtNavMeshQuery *query) const { dtFreeNavMeshQuery(query); }
};

// What Recast gets, checked.
struct Ground {
    std::vector<float> vertices;  // xyz
    std::vector<int> triangles;
    std::vector<Prism> holes, doors;
    std::vector<Byway> byways;
    Float3 min{}, max{};
    float radius = 0, height = 0, slope_deg = 0, step = 0, cell = 0, cell_height = 0;
    uint64_t max_cells = 0;
};

struct Mesh {
    double origin_m[3] = {};
    double metres_per_unit = 1;
    float radius = 0;
    std::unique_ptr<dtNavMesh, FreeNavMesh> nav;
    std::unique_ptr<dtNavMeshQuery, FreeQuery> query;
    dtQueryFilter open;        // without closed doors
    dtQueryFilter everything;  // of walkers that stand in one
    std::vector<Door> doors;
    bool has_byways = false;
    uint64_t version = 1;  // rises when a door moves
    uint32_t tiles = 0, polygons = 0;
    double area_m2 = 0;
    uint64_t bytes = 0;
    Float3 min{}, max{};
    mutable std::mutex lock;

    Float3 local(const double point[3]) const;
    void world(const float *local, double out[3]) const;
};

// Throws stage::Error or std::bad_alloc.
void make_mesh(const clq_navigation_def &def, Mesh &out);
// Steps of make_mesh.
Ground read_ground(const clq_navigation_def &def, Mesh &out);
void build_tiles(const Ground &ground, Mesh &out);
void find_doors(size_t count, Mesh &out);

unsigned short flags_of(const Mesh &mesh, dtPolyRef polygon);
// Ground for a way between two polygons: without closed doors, and without byways in which neither end lies.
dtQueryFilter filter_of_way(const Mesh &mesh, dtPolyRef from_ref, dtPolyRef to_ref);

void set_door(Mesh &mesh, uint32_t door, bool open);

// The nearest place on the ground; 0: there is none within reach (metres).
dtPolyRef nearest(const Mesh &mesh, const Float3 &point, float reach, const dtQueryFilter &filter, Float3 &out);

struct Way {
    std::vector<dtPolyRef> polygons;
    bool complete = false;
    Float3 end{};  // on the last polygon, as near to the goal as can be
};
// Both ends lie on the ground.
void find_way(const Mesh &mesh, dtPolyRef from_ref, const Float3 &from, dtPolyRef to_ref, const Float3 &to,
              const dtQueryFilter &filter, Way &out);

}  // namespace claque::walk

struct clq_navigation : claque::walk::Mesh {
    std::atomic<uint32_t> holders{1};
};
