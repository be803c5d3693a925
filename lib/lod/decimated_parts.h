// Levels as parts, from what stands at each corner of the triangles that are left. Between the files of this room only.
#pragma once

#include "lib/lod/welded_surface.h"

namespace claque::lod
{

// A vertex of a level: of which corner of the source it has its place and influences, and of which the part, the normal
// and the place in the texture. One and the same, but where corners are carried over plainly (plain.h).
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
    size_t flipped = 0;  // turned over in their texture
};

// Which way each face lies in its texture: -1, 0 or 1, by number of face.
class UvOrientations
{
public:
    explicit UvOrientations(const WeldedSurface &surface);
    bool flipped(const WeldedSurface &surface, Mesh::FaceHandle face, const std::array<uint32_t, 3> &corners) const;

private:
    std::vector<int8_t> orientations_;
};

// The levels, finest first: vertices of coarse ones stand first, so that a level's are the first of every finer one.
std::vector<Decimated> build_decimated(const WeldedSurface &surface, size_t part_count,
                                       const std::vector<LevelTriangles> &levels);

}  // namespace claque::lod
