// bake_swatches: the shared image of proxies with one zone per triangle (proxy_image.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "lib/lod/proxies/proxy_image.h"
#include "lib/lod/proxies/proxy_zones.h"

namespace claque::lod
{

namespace
{

constexpr uint32_t max_shades = 8;  // per zone

// Levels of at most so many triangles get one shade per tint, because vertices between shades are split.
constexpr size_t one_shade_triangles = 64;
// Quantisation step of a colour's difference from its grey. A zone that varies only in brightness has one tint.
constexpr double tint_step = 0.25;
constexpr uint32_t swatch_px = 4;         // equal texels across a swatch, so that rounding never samples a neighbour
constexpr uint32_t swatches_across = 16;  // across the image

constexpr double min_weight = 0.5, max_weight = 3;  // of a wrong zone where the source has few or many triangles

struct Swatch {
    uint32_t zone = 0, shade = 0, shades = 1;  // index and count of shades
    std::array<int, 3> tint{};                 // in steps
    bool operator<(const Swatch &o) const
    {
        return std::tie(zone, shades, shade, tint) < std::tie(o.zone, o.shades, o.shade, o.tint);
    }
};

struct ColourSum {
    glm::dvec3 colour = glm::dvec3(0);
    double area = 0;
    ColourSum &operator+=(const ColourSum &o)
    {
        colour += o.colour, area += o.area;
        return *this;
    }
    glm::dvec3 mean() const { return area > 0 ? colour / area : glm::dvec3(1); }
};
using ColourSums = std::vector<ColourSum>;  // [texture sets] in which the point shows the same zone as in the first set

void add(const ColourSums &from, ColourSums &to)
{
    to.resize(from.size());
    for (size_t i = 0; i < from.size(); ++i) to[i] += from[i];
}

// The colours of the source surface nearest to one triangle, by zone.
using ZoneColours = std::map<uint32_t, ColourSums>;

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
    const std::vector<PointPair> back = nearest_pairs(part, source.fine);
    for (const PointPair &pair : out) {
        const uint32_t t = pair.here.triangle;
        if (pair.corner == PointPair::inside && source.visibility[t] > 0)
            add_colour(source, pair.here, area_of(source.fine, t) * source.visibility[t],
                       zone_colours[pair.there.triangle]);
    }
    std::vector<SurfacePoint> centres(zone_colours.size());  // the first sample of a triangle is its centre
    for (auto pair = back.rbegin(); pair != back.rend(); ++pair)
        if (pair->corner == PointPair::inside) centres[pair->here.triangle] = pair->there;
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
        weights.push_back(std::clamp(std::sqrt(density), min_weight, max_weight));
    }
    return weights;
}

// Returns the area of each zone that each triangle of the level stands for. Small triangles of the source count more
// than their area, as above: a triangle from the head to the chest then shows the face.
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
        const double weight = std::clamp(std::sqrt(all / double(count) / area), min_weight, max_weight);
        areas[pair.there.triangle][zone_at(source.model, source.fine, pair.here)] +=
            weight * area * source.visibility[t];
    }
    for (size_t t = 0; t < areas.size(); ++t)
        for (const auto &[zone, sums] : zone_colours[t]) areas[t].try_emplace(zone, sums[0].area);
    return areas;
}

// The mean colour of each zone, for triangles that show a zone without samples of it.
ZoneColours usual_colours(const std::vector<ZoneColours> &all)
{
    ZoneColours usual;
    for (const ZoneColours &zone_colours : all)
        for (const auto &[zone, sums] : zone_colours) add(sums, usual[zone]);
    return usual;
}

Swatch swatch_of(const ProxySource &source, const ZoneColours &zone_colours, uint32_t zone, const ZoneColours &usual,
                 uint32_t shades, std::map<Swatch, ColourSums> &colours)
{
    ColourSums shown(source.set_count(), ColourSum{glm::dvec3(1), 1});
    const auto own = zone_colours.find(zone), other = usual.find(zone);
    if (own != zone_colours.end() && own->second[0].area > 0) shown = own->second;
    else if (other != usual.end() && other->second[0].area > 0) shown = other->second;
    const glm::dvec3 colour = shown[0].mean();
    Swatch swatch;
    swatch.zone = zone, swatch.shades = shades;
    const double mean = (colour.x + colour.y + colour.z) / 3;
    swatch.shade = std::min(shades - 1, static_cast<uint32_t>(mean * shades));
    for (int k = 0; k < 3; ++k) swatch.tint[size_t(k)] = static_cast<int>(std::lround((colour[k] - mean) / tint_step));
    add(shown, colours[swatch]);
    return swatch;
}

model::Image image_of(const ProxySource &source, const std::map<Swatch, ColourSums> &colours, size_t set)
{
    uint32_t rows = 1;
    while (rows * swatches_across < colours.size()) rows *= 2;
    model::Image image = empty_image(swatch_px * swatches_across, swatch_px * rows);
    const auto paint = [&](uint32_t at, const Swatch &swatch, const ColourSums &sums) {
        const size_t x = swatch_px * (at % swatches_across), y = swatch_px * (at / swatches_across);
        for (size_t i = 0; i < swatch_px * swatch_px; ++i)
            set_texel(source, (y + i / swatch_px) * image.width + x + i % swatch_px, swatch.zone,
                      sums[sums[set].area > 0 ? set : 0].mean(), image);
    };
    uint32_t at = 0;
    for (const auto &[swatch, sums] : colours) paint(at++, swatch, sums);
    // Unused texels copy the first swatch, so that no key names a missing zone.
    while (at < rows * swatches_across) paint(at++, colours.begin()->first, colours.begin()->second);
    return image;
}

}  // namespace

std::vector<model::Image> bake_swatches(const ProxySource &source, std::vector<model::Part> &parts,
                                        const std::vector<double> &tolerances)
{
    std::map<Swatch, ColourSums> colours;
    std::vector<std::vector<Swatch>> swatches;
    ZoneGoals goals{source.area_fractions[0]};
    for (size_t v = 0; v < source.views.count(); ++v) goals.views.source.push_back(source.views.fractions(v));
    for (const model::Part &part : parts) {
        goals.tolerance = tolerances[swatches.size()];
        goals.views.triangles = source.views.triangle_fractions(part);
        const PosedParts coarse = source.at_rest(part);
        const std::vector<PointPair> out = nearest_pairs(source.fine, coarse);
        const std::vector<ZoneColours> zone_colours = collect_colours(source, coarse, out);
        const std::vector<uint32_t> zones =
            assign_zones(source.model, source.fine, coarse, zone_areas_of(source, zone_colours, out), goals,
                         weights_of(source, coarse, out));
        const uint32_t shades = zone_colours.size() <= one_shade_triangles ? 1 : max_shades;
        const ZoneColours usual = usual_colours(zone_colours);
        swatches.emplace_back();
        for (size_t t = 0; t < zone_colours.size(); ++t)
            swatches.back().push_back(swatch_of(source, zone_colours[t], zones[t], usual, shades, colours));
    }
    std::vector<model::Image> images;
    for (size_t set = 0; set < source.set_count(); ++set) images.push_back(image_of(source, colours, set));
    std::map<Swatch, glm::vec2> uvs;
    uint32_t at = 0;
    for (const auto &entry : colours) {
        const uint32_t x = swatch_px * (at % swatches_across), y = swatch_px * (at / swatches_across);
        uvs[entry.first] = {(float(x) + 0.5f * swatch_px) / float(images[0].width),
                            (float(y) + 0.5f * swatch_px) / float(images[0].height)};
        ++at;
    }
    for (size_t i = 0; i < parts.size(); ++i) {
        std::vector<glm::vec2> corners;
        for (const Swatch &swatch : swatches[i]) corners.insert(corners.end(), 3, uvs.at(swatch));
        split_by_uv(parts[i], corners);
    }
    return images;
}

}  // namespace claque::lod
