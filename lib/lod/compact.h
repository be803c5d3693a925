// Levels as parts, from what stands at each corner of the triangles that are left. Between the files of this room only.
#pragma once

#include "lib/lod/surface.h"

namespace claque::lod
{

// A vertex of a level: of which corner of the source it has its place and influences, and of which the part, the normal
// and the place in the texture. One and the same, but where corners are carried over plainly (plain.h).
struct Vertex {
    uint32_t at = 0, look = 0;
    bool operator==(const Vertex &o) const { return at == o.at && look == o.look; }
    bool operator<(const Vertex &o) const { return look != o.look ? look < o.look : at < o.at; }
};

struct Left {
    std::vector<std::array<Vertex, 3>> triangles;
    size_t flipped = 0;  // turned over in their texture
};

// Which way each face lies in its texture: -1, 0 or 1, by number of face.
class UvSides
{
public:
    explicit UvSides(const Surface &surface);
    bool flipped(const Surface &surface, Mesh::FaceHandle face, const std::array<uint32_t, 3> &corners) const;

private:
    std::vector<int8_t> sides_;
};

// The levels, finest first: vertices of coarse ones stand first, so that a level's are the first of every finer one.
std::vector<Decimated> compact(const Surface &surface, size_t part_count, const std::vector<Left> &levels);

}  // namespace claque::lod
