// Finds the zones that each triangle can show, and makes the index lists: clean bins, dirty ranges, and the fused
// stream with its vertex copies. S1 3 (bins, dirty triangles), SPEC 3 (binned, fused).
#pragma once

#include "lib/model/template.h"
#include "meshsplit/mesh.h"

namespace claque::meshsplit
{

// The zones that each triangle can show, ascending, at least one: indices of its texture's keys.
struct TriangleZones {
    std::vector<uint32_t> first;  // [triangles + 1] offsets into `zones`
    std::vector<uint16_t> zones;

    uint32_t count(size_t triangle) const { return first[triangle + 1] - first[triangle]; }
    const uint16_t *of(size_t triangle) const { return zones.data() + first[triangle]; }
};

// A triangle that shows only holes counts as one of the lowest zone; holes never make a triangle dirty.
TriangleZones zones_of_triangles(const Mesh &mesh, const model::Array<model::Texture> &textures);

// Fills vertex_count, copies, slots, indices and surfaces of a level whose source_count is set. Triangles of the mesh
// are sorted by part, and the parts are numbered from 0.
void make_streams(const Mesh &mesh, const TriangleZones &zones, uint32_t part_count, model::Level &out);

}  // namespace claque::meshsplit
