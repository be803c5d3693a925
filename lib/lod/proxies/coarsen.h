// Simplifies a closed surface and lets vertices move freely. Levels of a few dozen triangles need this: if they kept
// vertices of the source, arms and heads would become spikes. Internal to lib/lod/proxies.
#pragma once

#include "lib/lod/proxies/features.h"
#include "lib/lod/proxies/marching_tetrahedra.h"

namespace claque::lod
{

struct CoarseMesh {
    ClosedMesh surface;
    std::vector<Features> features;  // [positions]
};

// Returns one mesh for each target; targets descend strictly. An edge collapses to the point that minimises the quadric
// of the planes round it (Garland and Heckbert 1997). The cost also contains what a merge adds to the variance of the
// features (Ward's rule), so vertices with different features merge last. No triangle flips and no edge gets more than
// two triangles, unless a target cannot be reached otherwise (non_manifold_collapse.h). Components of less than a
// fiftieth of the surface are dropped. Deterministic.
std::vector<CoarseMesh> coarsen(const ClosedMesh &surface, const std::vector<Attributes> &features,
                                const std::vector<size_t> &targets);

// Vertices keep the order in which triangles name them.
CoarseMesh without_unused_vertices(const CoarseMesh &mesh);

}  // namespace claque::lod
