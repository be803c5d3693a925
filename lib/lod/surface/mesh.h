// The triangle mesh with neighbourhoods, by OpenMesh. Internal to lib/lod.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <glm/vec3.hpp>

#include "lib/lod/surface/link_condition.h"

namespace claque::lod
{

struct MeshTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
struct Mesh : OpenMesh::TriMesh_ArrayKernelT<MeshTraits> {
    // The decimater calls this in place of OpenMesh's own.
    bool is_collapse_ok(HalfedgeHandle h) const { return LinkCondition<Mesh>(*this).holds(h); }
};

inline glm::dvec3 point(const Mesh &mesh, Mesh::VertexHandle v)
{
    const Mesh::Point &p = mesh.point(v);
    return {p[0], p[1], p[2]};
}

}  // namespace claque::lod
