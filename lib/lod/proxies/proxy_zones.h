// Assigns a zone to each triangle of a proxy. Internal to lib/lod/proxies.
#pragma once

#include <map>
#include <vector>

#include "lib/lod/proxies/view_cost.h"
#include "lib/lod/surface/area_fractions.h"
#include "lib/lod/surface/surface_samples.h"

namespace claque::lod
{

// The area nearest to one triangle, by zone.
using ZoneAreas = std::map<uint32_t, double>;

// What a level's zones shall keep of the source's.
struct ZoneGoals {
    const std::vector<double> &area_fractions;  // of the whole surface (area_fractions.h)
    double tolerance = max_zone_area_error;     // of each of them
    ZonesInViews views = {};                    // what single views show of the zones; may be empty
};

// Returns a zone for each triangle of `level`. Each triangle first takes the zone of most of its area. Where the level
// then misses its goals, the triangles with the least cost change, until all area fractions are within the tolerance
// and no change helps. Among equal assignments neighbours share zones, so that fewer vertices are split. `weights`: how
// much a wrong zone on each triangle matters; empty: 1 each. `source` and `level` are at rest. Deterministic.
std::vector<uint32_t> assign_zones(const model::Model &model, const PosedParts &source, const PosedParts &level,
                                   const std::vector<ZoneAreas> &zone_areas, const ZoneGoals &goals,
                                   const std::vector<double> &weights = {});

}  // namespace claque::lod
