// Extracts the surface between filled and empty cells by marching tetrahedra. It is closed, and no edge has more than
// two triangles, for any set of cells. Internal to lib/lod/proxies.
#pragma once

#include "lib/lod/proxies/voxels.h"

namespace claque::lod
{

struct ClosedMesh {
    std::vector<glm::dvec3> positions;
    std::vector<std::array<uint32_t, 3>> triangles;  // counter-clockwise from outside
};

ClosedMesh extract_closed_mesh(const Voxels &voxels);

}  // namespace claque::lod
