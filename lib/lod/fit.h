// A coarse surface's vertices, moved to where it lies nearest to the fine one that it stands for, its triangles as they are:
// the inner problem of Hoppe et al. 1993 (Mesh Optimization, 4.1). Quadrics keep to planes, which have no end, and so cut off
// what is thin: hands, feet, heads. Between the files of this room only.
#pragma once

#include "lib/lod/fine_surface.h"

namespace claque::lod
{

constexpr int max_fit_rounds = 12;

// Its vertices' places, in so many rounds at most, and what they stand for. The mean squared distance between the two surfaces, from either to the
// other, does not grow, and no triangle turns over. Deterministic.
void fit(const FineSurface &fine, CoarseMesh &coarse, int rounds = max_fit_rounds);

}  // namespace claque::lod
