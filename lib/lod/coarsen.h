// A closed surface in fewer triangles, whose vertices may stand anywhere: what levels of a few dozen triangles need, where
// keeping vertices of the source would make spikes of arms and heads. Between the files of this room only.
#pragma once

#include "lib/lod/features.h"
#include "lib/lod/marching_tetrahedra.h"

namespace claque::lod
{

struct CoarseMesh {
    ClosedMesh surface;
    std::vector<Features> features;  // [positions]
};

// One for each target, descending strictly. An edge is collapsed to where the planes round it are nearest (Garland and
// Heckbert 1997); vertices whose features differ are brought together last, by what it adds to the variance of each
// (Ward's rule). No triangle turns over, and no edge comes to have more than two, while there is another way down to a
// target (pinch.h). Pieces of less than a fiftieth of the surface are left out. Deterministic.
std::vector<CoarseMesh> coarsen(const ClosedMesh &surface, const std::vector<Attributes> &features,
                                const std::vector<size_t> &targets);

}  // namespace claque::lod
