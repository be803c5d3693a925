#include "lib/lod/proxies/zone_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "lib/lod/surface/point_tree.h"

namespace claque::lod
{

ZoneCost::ZoneCost(const model::Model &model, const PosedParts &source, const PosedParts &level,
                   const std::vector<ZoneAreas> &zone_areas, const ZoneValues &areas,
                   const std::vector<double> &weights)
    : zones_(model.zones.size() + 1)
{
    std::vector<std::vector<glm::dvec3>> centres(zones_);
    glm::dvec3 first(std::numeric_limits<double>::infinity()), last = -first;
    for (uint32_t t = 0; t < source.triangles().size(); ++t) {
        const glm::dvec3 third(1.0 / 3);
        const glm::dvec3 p = position_of(source, {t, third});
        first = glm::min(first, p), last = glm::max(last, p);
        if (is_hole(model, source, {t, third})) continue;
        centres[std::min<size_t>(zone_at(model, source, {t, third}), zones_ - 1)].push_back(p);
    }
    const double size = std::max({last.x - first.x, last.y - first.y, last.z - first.z, 1e-30});
    std::vector<PointTree> nearest;
    std::vector<uint32_t> known;
    for (uint32_t zone = 0; zone < zones_; ++zone)
        if (!centres[zone].empty()) known.push_back(zone), nearest.emplace_back(centres[zone]);
    for (uint32_t t = 0; t < level.triangles().size(); ++t) {
        ZoneValues row(zones_, 4);
        double all = 0;
        for (const auto &[zone, area] : zone_areas[t]) all += area;
        const glm::dvec3 middle = position_of(level, {t, glm::dvec3(1.0 / 3)});
        for (size_t i = 0; i < known.size(); ++i)
            row[known[i]] = 1 + std::sqrt(nearest[i].to(middle).distance_squared) / size;
        for (const auto &[zone, area] : zone_areas[t])
            row[std::min<size_t>(zone, zones_ - 1)] = all > 0 ? 1 - area / all : 0;
        for (double &one : row) one *= weights.empty() ? areas[t] : weights[t] * areas[t];
        rows_.push_back(std::move(row));
    }
}

size_t ZoneCost::cheapest(size_t triangle, const ZoneValues &fractions) const
{
    const ZoneValues &row = rows_[triangle];
    const auto is_less = [&](size_t a, size_t b) {
        return (fractions[a] > 0) != (fractions[b] > 0) ? fractions[a] > 0 : row[a] < row[b];
    };
    size_t best = 0;
    for (size_t zone = 1; zone < zones_; ++zone)
        if (is_less(zone, best)) best = zone;
    return best;
}

}  // namespace claque::lod
