// Which zone each triangle of a far level shows. Between the files of this room only.
#pragma once

#include <map>
#include <vector>

#include "lib/lod/surface_samples.h"

namespace claque::lod
{

// Of one triangle: how much of each zone is nearest to it.
using ZoneAreas = std::map<uint32_t, double>;

// A zone each for the triangles of `level`: each would show what most of it stands for, and where then some zone had more
// or less of the surface than `shares` says (shares.h), those change that it does least harm to, until all are within 2
// points of it or nothing more helps. Of ways that are as good triangles beside each other show the same, so that fewer
// vertices stand twice. Both are at rest; `seen` [triangles of level]. Deterministic.
std::vector<uint32_t> assign_zones(const model::Model &model, const PosedParts &source, const PosedParts &level,
                                   const std::vector<ZoneAreas> &zone_areas, const std::vector<double> &area_fractions);

}  // namespace claque::lod
