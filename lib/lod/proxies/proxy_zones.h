// Assigns a zone to each triangle of a proxy. Internal to lib/lod/proxies.
#pragma once

#include <map>
#include <vector>

#include "lib/lod/surface/surface_samples.h"

namespace claque::lod
{

// The area nearest to one triangle, by zone.
using ZoneAreas = std::map<uint32_t, double>;

// Returns a zone for each triangle of `level`. Each triangle first takes the zone of most of its area. Where a zone's
// area fraction then differs from `area_fractions` (area_fractions.h), the triangles with the least cost change, until
// all zones are within 2 points or no change helps. Among equal assignments neighbours share zones, so that fewer
// vertices are split. `weights`: how much a wrong zone on each triangle matters; empty: 1 each. `source` and `level`
// are at rest. Deterministic.
std::vector<uint32_t> assign_zones(const model::Model &model, const PosedParts &source, const PosedParts &level,
                                   const std::vector<ZoneAreas> &zone_areas, const std::vector<double> &area_fractions,
                                   const std::vector<double> &weights = {});

}  // namespace claque::lod
