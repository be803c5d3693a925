// Builds the parts of levels from the corners of the remaining triangles. Internal to lib/lod/decimation.
#pragma once

#include "lib/lod/decimation/welded_surface.h"

namespace claque::lod
{

// A vertex of a level. `position_corner`: source corner for position and influences. `attribute_corner`: source corner
// for part, normal and texture coordinates. They differ only in decimate_quadric_only.
struct LevelVertex {
    uint32_t position_corner = 0, attribute_corner = 0;
    bool operator==(const LevelVertex &o) const
    {
        return position_corner == o.position_corner && attribute_corner == o.attribute_corner;
    }
    bool operator<(const LevelVertex &o) const
    {
        return attribute_corner != o.attribute_corner ? attribute_corner < o.attribute_corner
                                                      : position_corner < o.position_corner;
    }
};

struct LevelTriangles {
    std::vector<std::array<LevelVertex, 3>> triangles;
    size_t flipped = 0;  // flipped in texture space
};

// The orientation of each face in its texture, by face index: -1, 0 or 1.
class UvOrientations
{
public:
    explicit UvOrientations(const WeldedSurface &surface);
    bool flipped(const WeldedSurface &surface, Mesh::FaceHandle face, const std::array<uint32_t, 3> &corners) const;

private:
    std::vector<int8_t> orientations_;
};

// Returns the levels, finest first. Vertices of coarse levels come first, so a level's vertices are a prefix of those
// of every finer level.
std::vector<Decimated> build_decimated(const WeldedSurface &surface, size_t part_count,
                                       const std::vector<LevelTriangles> &levels);

}  // namespace claque::lod
