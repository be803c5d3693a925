// Finds the zones that each triangle can show, and makes the index lists: clean bins, dirty ranges, and the fused
// stream with its vertex copies. S1 3 (bins, dirty triangles).
#pragma once

#include "lib/model/template.h"
#include "meshsplit/cover.h"
#include "meshsplit/mesh.h"

namespace claque::meshsplit
{

// The zones that each triangle can show, ascending, at least one: indices of its texture's keys.
struct TriangleZones {
    std::vector<uint32_t> first;  // [triangles + 1] offsets into `zones`
    std::vector<uint16_t> zones;

    uint32_t count(size_t triangle) const { return first[triangle + 1] - first[triangle]; }
    const uint16_t *of(size_t triangle) const { return zones.data() + first[triangle]; }
    size_t triangles() const { return first.size() - 1; }
    size_t besides_first() const { return zones.size() - triangles(); }

    // Three indices in two streams, three copies of vertices with what finds them, and places in lists, in arrays that
    // grow by doubling.
    static constexpr uint64_t bytes_per_zone = 512;
};

// The content of one texture set: per texel the index of its zone in the texture's keys.
struct ZoneImage {
    TexelGrid grid;
    std::vector<uint16_t> zones;
};

// The zones of all textures, in all texture sets; none for textures with one zone.
struct ZoneImages {
    explicit ZoneImages(const model::Array<model::Texture> &textures);
    std::vector<std::vector<ZoneImage>> images;  // [textures]
    std::vector<size_t> zone_counts;             // [textures]
};

// What several zones of a triangle may take in the streams of all levels, and how many texels of one texture may be
// looked at for one level.
struct ZoneLimits {
    uint64_t bytes = ~0ull, texels = ~0ull;
    uint64_t source_bytes = 0;  // read of a file, and the zones of all textures: for the sentence of a refusal
    size_t zones = 0;
};

// A triangle that shows only holes counts as one of the lowest zone; holes never make a triangle dirty. Throws
// base::Error (LIMIT).
TriangleZones zones_of_triangles(const Mesh &mesh, const ZoneImages &zone_images, const ZoneLimits &limits = {});

// Returns what the zones of triangles besides their first take in the streams of all levels, at most. Throws
// base::Error (LIMIT).
uint64_t stream_bytes(const std::vector<TriangleZones> &levels, const ZoneLimits &limits);

// Fills vertex_count, copies, slots, indices and surfaces of a level whose source_count is set. Triangles of the mesh
// are sorted by part, and the parts are numbered from 0.
void make_streams(const Mesh &mesh, const TriangleZones &zones, uint32_t part_count, model::Level &out);

}  // namespace claque::meshsplit
