// Moves the vertices of a coarse surface to fit it to the fine one, with fixed triangles: the inner problem of Hoppe et
// al. 1993 (Mesh Optimization, 4.1). Quadrics alone cut off thin parts such as hands, feet and heads, because the
// planes that they keep to are infinite. Internal to lib/lod/proxies.
#pragma once

#include "lib/lod/proxies/fine_surface.h"

namespace claque::lod
{

constexpr int max_fit_rounds = 12;

// Fits the positions in at most `rounds` iterations and updates the features. The mean squared distance between the two
// surfaces, in both directions, does not grow, and no triangle flips. Deterministic.
void fit(const FineSurface &fine, CoarseMesh &coarse, int rounds = max_fit_rounds);

}  // namespace claque::lod
