#include "lib/lod/proxies/swatch_zones.h"

#include <algorithm>
#include <cmath>

#include "lib/lod/proxies/proxy_zones.h"

namespace claque::lod
{

namespace
{

constexpr double min_weight = 0.5, max_weight = 8;  // of a wrong zone where the source has few or many triangles

void add_colour(const ProxySource &source, const SurfacePoint &point, double area, ZoneColours &zone_colours)
{
    const uint32_t zone = zone_at(source.model, source.fine, point);
    ColourSums &sums = zone_colours.try_emplace(zone, source.set_count()).first->second;
    for (size_t i = 0; i < sums.size(); ++i)
        if (i == 0 || zone_at(source.model, source.fine, point, source.set(i)) == zone)
            sums[i] += {area * texel_at(source.model, source.fine, point, source.set(i)), area};
}

std::vector<ZoneColours> collect_colours(const ProxySource &source, const PosedParts &part,
                                         const std::vector<PointPair> &out)
{
    std::vector<ZoneColours> zone_colours(part.triangles().size());
    const std::vector<PointPair> back = source.trees.nearest_pairs(part);
    for (const PointPair &pair : out) {
        const uint32_t t = pair.here.triangle;
        if (pair.corner == PointPair::inside && source.visibility[t] > 0 &&
            !is_hole(source.model, source.fine, pair.here))
            add_colour(source, pair.here, area_of(source.fine, t) * source.visibility[t],
                       zone_colours[pair.there.triangle]);
    }
    std::vector<SurfacePoint> centres(zone_colours.size());  // the first sample of a triangle is its centre
    for (auto pair = back.rbegin(); pair != back.rend(); ++pair)
        if (pair->corner == PointPair::inside)
            centres[pair->here.triangle] = source.through_holes(pair->there, position_of(part, pair->here));
    for (size_t t = 0; t < zone_colours.size(); ++t)
        if (zone_colours[t].empty()) add_colour(source, centres[t], 1, zone_colours[t]);
    return zone_colours;
}

// Returns how much a wrong zone on each triangle of the level matters. Where its maker gave the source more triangles
// for the same area, as on a face, people look.
std::vector<double> weights_of(const ProxySource &source, const PosedParts &part, const std::vector<PointPair> &out)
{
    std::vector<double> counts(part.triangles().size(), 0), areas(counts);
    double count = 0, area = 0;
    for (const PointPair &pair : out) {
        const uint32_t t = pair.here.triangle;
        if (pair.corner != PointPair::inside || !(source.visibility[t] > 0)) continue;
        const double here = area_of(source.fine, t) * source.visibility[t];
        counts[pair.there.triangle] += source.visibility[t], areas[pair.there.triangle] += here;
        count += source.visibility[t], area += here;
    }
    std::vector<double> weights;
    for (size_t t = 0; t < counts.size(); ++t) {
        const double density = areas[t] > 0 ? counts[t] / areas[t] * area / count : 1;
        weights.push_back(std::clamp(density, min_weight, max_weight));
    }
    return weights;
}

// Returns the area of each zone that each triangle of the level stands for. Small triangles of the source count more
// than their area: a triangle from the head to the chest then shows the face.
std::vector<ZoneAreas> zone_areas_of(const ProxySource &source, const std::vector<ZoneColours> &zone_colours,
                                     const std::vector<PointPair> &out)
{
    std::vector<ZoneAreas> areas(zone_colours.size());
    double all = 0;
    const size_t count = source.fine.triangles().size();
    for (uint32_t t = 0; t < count; ++t) all += area_of(source.fine, t);
    for (const PointPair &pair : out) {
        const uint32_t t = pair.here.triangle;
        const double area = area_of(source.fine, t);
        if (pair.corner != PointPair::inside || !(source.visibility[t] > 0) || !(area > 0)) continue;
        if (is_hole(source.model, source.fine, pair.here)) continue;
        const double weight = std::clamp(std::sqrt(all / double(count) / area), min_weight, max_weight);
        areas[pair.there.triangle][zone_at(source.model, source.fine, pair.here)] +=
            weight * area * source.visibility[t];
    }
    for (size_t t = 0; t < areas.size(); ++t)  // those that no sample of the source is nearest to
        for (const auto &[zone, sums] : zone_colours[t]) areas[t].try_emplace(zone, sums[0].area);
    return areas;
}

}  // namespace

SwatchZones swatch_zones_of(const ProxySource &source, const model::Part &part, double tolerance)
{
    ZoneGoals goals{source.area_fractions[0]};
    goals.tolerance = tolerance;
    for (size_t v = 0; v < source.views.count(); ++v) goals.views.source.push_back(source.views.fractions(v));
    goals.views.triangles = source.views.triangle_fractions(part);
    const PosedParts coarse = source.at_rest(part);
    const std::vector<PointPair> out = nearest_pairs(source.fine, coarse);
    SwatchZones chosen;
    chosen.colours = collect_colours(source, coarse, out);
    chosen.zones = assign_zones(source.model, source.fine, coarse, zone_areas_of(source, chosen.colours, out), goals,
                                weights_of(source, coarse, out));
    return chosen;
}

}  // namespace claque::lod
