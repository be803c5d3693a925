// Simplifies by the visible loss, for levels of a few dozen triangles, in which each collapse removes or keeps a limb.
// Internal to lib/lod/proxies.
#pragma once

#include "lib/base/services.h"
#include "lib/lod/proxies/fine_surface.h"

namespace claque::lod
{

// Returns the closed mesh `from` in fewer triangles, one mesh for each target, descending. The next edge to collapse is
// the one that adds least to the squared distance between the two surfaces, in both directions, plus the variance of
// the features. Stops above a target if no legal collapse is left. Each result is fitted (fit.h). Deterministic.
std::vector<CoarseMesh> reduce_by_distance(const FineSurface &fine, const CoarseMesh &from,
                                           const std::vector<size_t> &targets, const base::Jobs &jobs = {});

}  // namespace claque::lod
