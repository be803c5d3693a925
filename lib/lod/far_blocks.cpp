#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "lib/lod/far_image.h"
#include "lib/lod/far_zones.h"

namespace claque::lod
{

namespace
{

constexpr uint32_t most_shades = 8;     // of one zone
constexpr size_t plain_triangles = 64;  // from here down one shade a tint: vertices between shades stand twice
constexpr double tint_step = 0.25;      // of colours off their grey: zones of light and dark alone have one tint
constexpr uint32_t block = 4;           // texels across that are alike, so that no rounding reaches a neighbour
constexpr uint32_t blocks_across = 16;  // of the image

struct Look {
    uint32_t zone = 0, shade = 0, shades = 1;  // which of how many
    std::array<int, 3> tint{};                 // in steps
    bool operator<(const Look &o) const
    {
        return std::tie(zone, shades, shade, tint) < std::tie(o.zone, o.shades, o.shade, o.tint);
    }
};

struct BlockSum {
    glm::dvec3 colour = glm::dvec3(0);
    double area = 0;
    BlockSum &operator+=(const BlockSum &o)
    {
        colour += o.colour, area += o.area;
        return *this;
    }
    glm::dvec3 mean() const { return area > 0 ? colour / area : glm::dvec3(1); }
};
using Sums = std::vector<BlockSum>;  // [texture sets] where a set shows the zone of the first

void add(const Sums &from, Sums &to)
{
    to.resize(from.size());
    for (size_t i = 0; i < from.size(); ++i) to[i] += from[i];
}

// Of everything that is nearest to one triangle, by zone.
using Seen = std::map<uint32_t, Sums>;

void see(const FarSource &source, const Place &place, double area, Seen &seen)
{
    const uint32_t zone = zone_at(source.model, source.fine, place);
    Sums &sums = seen.try_emplace(zone, source.set_count()).first->second;
    for (size_t i = 0; i < sums.size(); ++i)
        if (i == 0 || zone_at(source.model, source.fine, place, source.set(i)) == zone)
            sums[i] += {area * texel_at(source.model, source.fine, place, source.set(i)), area};
}

std::vector<Seen> what_is_seen(const FarSource &source, const PosedParts &part)
{
    std::vector<Seen> seen(part.triangles().size());
    const std::vector<Pair> out = nearest_pairs(source.fine, part), back = nearest_pairs(part, source.fine);
    for (size_t i = 0; i < out.size(); ++i) {
        const uint32_t t = out[i].here.triangle;
        if (i % spots_per_triangle < area_spots && source.seen[t] > 0)
            see(source, out[i].here, area_of(source.fine, t) * source.seen[t], seen[out[i].there.triangle]);
    }
    for (size_t t = 0; t < seen.size(); ++t)
        if (seen[t].empty()) see(source, back[spots_per_triangle * t].there, 1, seen[t]);
    return seen;
}

std::vector<uint32_t> zones_of(const FarSource &source, const PosedParts &part, const std::vector<Seen> &seen)
{
    std::vector<ZoneAreas> areas(seen.size());
    for (size_t t = 0; t < seen.size(); ++t)
        for (const auto &[zone, sums] : seen[t]) areas[t][zone] = sums[0].area;
    return chosen_zones(source.model, source.fine, part, areas, source.shares[0]);
}

// Where a triangle shows a zone that it has seen nothing of, the zone's usual colour does.
Seen usual_of(const std::vector<Seen> &all)
{
    Seen usual;
    for (const Seen &seen : all)
        for (const auto &[zone, sums] : seen) add(sums, usual[zone]);
    return usual;
}

Look look_of(const FarSource &source, const Seen &seen, uint32_t zone, const Seen &usual, uint32_t shades,
             std::map<Look, Sums> &colours)
{
    Sums shown(source.set_count(), BlockSum{glm::dvec3(1), 1});
    const auto own = seen.find(zone), other = usual.find(zone);
    if (own != seen.end() && own->second[0].area > 0) shown = own->second;
    else if (other != usual.end() && other->second[0].area > 0) shown = other->second;
    const glm::dvec3 colour = shown[0].mean();
    Look look;
    look.zone = zone, look.shades = shades;
    const double mean = (colour.x + colour.y + colour.z) / 3;
    look.shade = std::min(shades - 1, static_cast<uint32_t>(mean * shades));
    for (int k = 0; k < 3; ++k) look.tint[size_t(k)] = static_cast<int>(std::lround((colour[k] - mean) / tint_step));
    add(shown, colours[look]);
    return look;
}

model::Image image_of(const FarSource &source, const std::map<Look, Sums> &colours, size_t set)
{
    uint32_t rows = 1;
    while (rows * blocks_across < colours.size()) rows *= 2;
    model::Image image = empty_image(block * blocks_across, block * rows);
    const auto paint = [&](uint32_t at, const Look &look, const Sums &sums) {
        const size_t x = block * (at % blocks_across), y = block * (at / blocks_across);
        for (size_t i = 0; i < block * block; ++i)
            set_texel(source, (y + i / block) * image.width + x + i % block, look.zone,
                      sums[sums[set].area > 0 ? set : 0].mean(), image);
    };
    uint32_t at = 0;
    for (const auto &[look, sums] : colours) paint(at++, look, sums);
    // Texels that nobody points at show what the first does, so that none names a zone that there is not.
    while (at < rows * blocks_across) paint(at++, colours.begin()->first, colours.begin()->second);
    return image;
}

}  // namespace

std::vector<model::Image> painted_in_blocks(const FarSource &source, std::vector<model::Part> &parts,
                                            const base::Jobs &jobs)
{
    std::vector<std::vector<Seen>> all(parts.size());
    std::vector<std::vector<uint32_t>> zones(parts.size());
    jobs.try_each(static_cast<uint32_t>(parts.size()), [&](uint32_t i) {
        const PosedParts coarse = source.at_rest(parts[i]);
        all[i] = what_is_seen(source, coarse);
        zones[i] = zones_of(source, coarse, all[i]);
    });
    std::map<Look, Sums> colours;
    std::vector<std::vector<Look>> looks;
    for (size_t i = 0; i < parts.size(); ++i) {
        const std::vector<Seen> &seen = all[i];
        const uint32_t shades = seen.size() <= plain_triangles ? 1 : most_shades;
        const Seen usual = usual_of(seen);
        looks.emplace_back();
        for (size_t t = 0; t < seen.size(); ++t)
            looks.back().push_back(look_of(source, seen[t], zones[i][t], usual, shades, colours));
    }
    std::vector<model::Image> images;
    for (size_t set = 0; set < source.set_count(); ++set) images.push_back(image_of(source, colours, set));
    std::map<Look, glm::vec2> places;
    uint32_t at = 0;
    for (const auto &entry : colours) {
        const uint32_t x = block * (at % blocks_across), y = block * (at / blocks_across);
        places[entry.first] = {(float(x) + 0.5f * block) / float(images[0].width),
                               (float(y) + 0.5f * block) / float(images[0].height)};
        ++at;
    }
    for (size_t i = 0; i < parts.size(); ++i) {
        std::vector<glm::vec2> corners;
        for (const Look &look : looks[i]) corners.insert(corners.end(), 3, places.at(look));
        give_uvs(parts[i], corners);
    }
    return images;
}

}  // namespace claque::lod
