// Coarser and coarser by what is seen to go: for levels of a few dozen triangles, where each collapse takes a limb or leaves
// it. Between the files of this room only.
#pragma once

#include "lib/base/services.h"
#include "lib/lod/fine_surface.h"

namespace claque::lod
{

// `from`, closed, in fewer triangles, one for each target, descending. The next edge to collapse is the one by which the
// squared distance of both surfaces, from either to the other, and the variance of what vertices stand for grow least. Stops
// above a target where no lawful collapse is left. Each result is fit (fit.h). Deterministic.
std::vector<CoarseMesh> reduce_by_distance(const FineSurface &fine, const CoarseMesh &from,
                                           const std::vector<size_t> &targets, const base::Jobs &jobs = {});

}  // namespace claque::lod
