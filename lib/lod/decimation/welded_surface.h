// The parts of a character as one OpenMesh mesh, welded where they touch. Each face corner refers to a corner of the
// source and keeps its normal, texture coordinates and influences. Internal to lib/lod/decimation.
#pragma once

#include <array>

#include "lib/lod/decimation/decimate.h"
#include "lib/lod/surface/mesh.h"
#include "lib/lod/surface/quadric.h"

namespace claque::lod
{

// The corners of the source at the corners of a face. They are found by vertex, so the order in which the mesh re-uses
// its halfedges does not matter.
struct Corners {
    std::array<int, 3> at{};
    std::array<uint32_t, 3> corner{};

    uint32_t of(int vertex) const
    {
        for (size_t k = 0; k < 3; ++k)
            if (at[k] == vertex) return corner[k];
        return model::none;
    }
};

class WeldedSurface
{
public:
    // Welds vertices of one part that share a position. Open borders of several parts that move together (all skinned,
    // or on one node) are welded as well: the parts are sewn, and no crack opens between them.
    explicit WeldedSurface(const std::vector<SourcePart> &parts);

    Mesh mesh;
    OpenMesh::FPropHandleT<Corners> corners;
    // Triangles on edges with more than two faces. They are separate and do not move.
    size_t non_manifold_triangles = 0;

    // A corner of the source is a vertex of a part, indexed through all parts.
    uint32_t corner_count() const { return first_.back(); }
    uint32_t part_of(uint32_t corner) const { return part_of_[corner]; }
    uint32_t vertex_of(uint32_t corner) const { return corner - first_[part_of_[corner]]; }
    const model::Part &part(uint32_t index) const { return *parts_[index].part; }
    glm::vec3 at_rest(uint32_t corner) const;
    // Corners that differ only in their normals are one wedge, named by the first of them.
    uint32_t wedge(uint32_t corner) const { return wedge_[corner]; }
    glm::vec2 uv(uint32_t corner) const;
    bool has_uv(uint32_t corner) const { return !part(part_of_[corner]).uvs.empty(); }

private:
    void find_wedges();

    std::vector<SourcePart> parts_;
    std::vector<uint32_t> first_, part_of_, wedge_;
};

}  // namespace claque::lod
