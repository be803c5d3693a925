// The cost of the zones of a level in their places. Internal to lib/lod/proxies.
#pragma once

#include <vector>

#include "lib/lod/proxies/proxy_zones.h"

namespace claque::lod
{

using ZoneValues = std::vector<double>;

// The cost of each zone on each triangle, in fractions of the surface: the part of what the triangle represents that
// shows another zone and, for zones that are absent there, their distance as a fraction of the character's size.
class ZoneCost
{
public:
    ZoneCost(const model::Model &model, const PosedParts &source, const PosedParts &level,
             const std::vector<ZoneAreas> &zone_areas, const ZoneValues &areas, const std::vector<double> &weights);

    double of(size_t triangle, size_t zone) const { return rows_[triangle][zone]; }
    // Of the zones that `fractions` has, if it has any.
    size_t cheapest(size_t triangle, const ZoneValues &fractions) const;

private:
    size_t zones_;
    std::vector<ZoneValues> rows_;
};

}  // namespace claque::lod
