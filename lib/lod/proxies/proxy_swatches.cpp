// bake_swatches: the shared image of proxies with one zone per triangle (proxy_image.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "lib/lod/proxies/proxy_image.h"

namespace claque::lod
{

namespace
{

constexpr uint32_t max_shades = 8;  // per zone

// Levels up to this size get one shade per tint, because vertices between shades are split. A zone that is a whole
// picture keeps its shades: its mean would be a person in one colour.
constexpr size_t one_shade_triangles = 64;
// Quantisation step of a colour's difference from its grey. A zone that varies only in brightness has one tint.
constexpr double tint_step = 0.25;
constexpr uint32_t swatch_px = 4;         // equal texels across a swatch, so that rounding never samples a neighbour
constexpr uint32_t swatches_across = 16;  // across the image

struct Swatch {
    uint32_t zone = 0, shade = 0, shades = 1;  // index and count of shades
    std::array<int, 3> tint{};                 // in steps
    bool operator<(const Swatch &o) const
    {
        return std::tie(zone, shades, shade, tint) < std::tie(o.zone, o.shades, o.shade, o.tint);
    }
};

// Zones that are whole pictures: a material of theirs has an image, so their colours are those of many things.
std::set<uint32_t> pictured_zones(const model::Model &model)
{
    std::set<uint32_t> pictured;
    for (const model::Material &material : model.materials)
        if (material.image != model::none) pictured.insert(material.zone);
    return pictured;
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

std::vector<model::Image> bake_swatches(const ProxySource &source, const std::vector<SwatchZones> &chosen,
                                        std::vector<model::Part> &parts)
{
    std::map<Swatch, ColourSums> colours;
    std::vector<std::vector<Swatch>> swatches;
    const std::set<uint32_t> pictured = pictured_zones(source.model);
    for (const SwatchZones &one : chosen) {
        const ZoneColours usual = usual_colours(one.colours);
        swatches.emplace_back();
        for (size_t t = 0; t < one.zones.size(); ++t) {
            const bool one_shade = one.zones.size() <= one_shade_triangles && pictured.count(one.zones[t]) == 0;
            swatches.back().push_back(
                swatch_of(source, one.colours[t], one.zones[t], usual, one_shade ? 1 : max_shades, colours));
        }
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
