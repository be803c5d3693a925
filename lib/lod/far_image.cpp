#include "lib/lod/far_image.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "lib/base/error.h"
#include "lib/lod/far_zones.h"
#include "lib/lod/samples.h"
#include "lib/lod/shares.h"
#include "lib/pose/pose.h"

namespace claque::lod
{

namespace
{

constexpr uint32_t most_shades = 8;     // of one zone
constexpr size_t plain_triangles = 64;  // from here down one shade a zone: vertices between shades stand twice
constexpr uint32_t block = 4;           // texels across that are alike, so that no rounding reaches a neighbour
constexpr uint32_t blocks_across = 16;  // of the image

struct Look {
    uint32_t zone = 0, shade = 0, shades = 1;  // which of how many
    bool operator<(const Look &o) const { return std::tie(zone, shades, shade) < std::tie(o.zone, o.shades, o.shade); }
};

// Of everything that is nearest to one triangle.
struct Seen {
    std::map<uint32_t, double> areas;        // by zone
    std::map<uint32_t, glm::dvec3> colours;  // sums, by zone
    void add(uint32_t zone, glm::dvec3 colour, double area)
    {
        areas[zone] += area;
        colours[zone] += area * colour;
    }
};

struct Colours {
    std::map<Look, std::pair<glm::dvec3, double>> sums;
};

std::vector<Seen> what_is_seen(const model::Model &model, const PosedParts &source, const PosedParts &part)
{
    std::vector<Seen> seen(part.triangles().size());
    const std::vector<Pair> out = nearest_pairs(source, part), back = nearest_pairs(part, source);
    for (size_t i = 0; i < out.size(); ++i)
        if (i % spots_per_triangle < area_spots)
            seen[out[i].there.triangle].add(zone_at(model, source, out[i].here), texel_at(model, source, out[i].here),
                                            area_of(source, out[i].here.triangle));
    for (size_t t = 0; t < seen.size(); ++t) {
        if (!seen[t].areas.empty()) continue;
        const Pair &pair = back[spots_per_triangle * t];
        seen[t].add(zone_at(model, source, pair.there), texel_at(model, source, pair.there), 1);
    }
    return seen;
}

// Where a triangle shows a zone that it has seen nothing of, the zone's usual colour does.
struct Usual {
    std::map<uint32_t, std::pair<glm::dvec3, double>> sums;
    explicit Usual(const std::vector<Seen> &all)
    {
        for (const Seen &seen : all)
            for (const auto &[zone, area] : seen.areas) {
                auto &[sum, weight] = sums.try_emplace(zone, glm::dvec3(0), 0.0).first->second;
                sum += seen.colours.at(zone), weight += area;
            }
    }
};

Look look_of(const Seen &seen, uint32_t zone, const Usual &usual, uint32_t shades, Colours &colours)
{
    Look look;
    look.zone = zone;
    const auto own = seen.areas.find(zone);
    const auto other = usual.sums.find(zone);
    const bool has = own != seen.areas.end() && own->second > 0;
    const glm::dvec3 colour = has                         ? seen.colours.at(zone)
                              : other != usual.sums.end() ? other->second.first
                                                          : glm::dvec3(1);
    const double area = has ? own->second : other != usual.sums.end() ? std::max(other->second.second, 1e-30) : 1;
    const double bright = (colour.x + colour.y + colour.z) / (3 * area);
    look.shades = shades;
    look.shade = std::min(shades - 1, static_cast<uint32_t>(bright * shades));
    auto &[sum, weight] = colours.sums[look];
    sum += colour, weight += area;
    return look;
}

// Keys that tell all zones apart: as they are where they do, else new ones for those that no image names.
std::vector<uint8_t> keys_of(const model::Model &model)
{
    std::vector<uint8_t> keys;
    std::set<uint8_t> taken;
    for (const model::Zone &zone : model.zones) keys.push_back(zone.key), taken.insert(zone.key);
    if (taken.size() == keys.size()) return keys;
    taken.clear();
    for (const model::Image &image : model.images)
        if (image.alpha == model::AlphaMeaning::zone_keys)
            for (size_t i = 3; i < image.rgba.size(); i += 4) taken.insert(image.rgba[i]);
    std::set<uint8_t> given;
    uint32_t next = 1;
    for (uint8_t &key : keys) {
        if (taken.count(key) && given.insert(key).second) continue;
        while (next < 256 && (taken.count(static_cast<uint8_t>(next)) || given.count(static_cast<uint8_t>(next))))
            ++next;
        if (next == 256) base::fail(CLQ_LIMIT, "'%s' has more zones than keys", model.name.c_str());
        key = static_cast<uint8_t>(next);
        given.insert(key);
    }
    return keys;
}

// The vertices of a part once for each look that they have.
void give_uvs(model::Part &part, const std::vector<Look> &looks, const std::map<Look, glm::vec2> &places)
{
    const model::Part from = part;
    part.positions.clear(), part.normals.clear(), part.uvs.clear(), part.joints.clear(), part.weights.clear();
    std::map<std::pair<uint32_t, Look>, uint32_t> known;
    for (size_t i = 0; i < part.indices.size(); ++i) {
        const uint32_t v = part.indices[i];
        const Look look = looks[i / 3];
        const auto [at, fresh] = known.try_emplace({v, look}, static_cast<uint32_t>(part.positions.size()));
        part.indices[i] = at->second;
        if (!fresh) continue;
        part.positions.push_back(from.positions[v]);
        part.normals.push_back(from.normals[v]);
        part.uvs.push_back(places.at(look));
        const size_t n = part.influence_count;
        for (size_t k = n * v; k < n * v + n; ++k)
            part.joints.push_back(from.joints[k]), part.weights.push_back(from.weights[k]);
    }
}

}  // namespace

FarLevels painted(const model::Model &model, const std::vector<const model::Part *> &source,
                  std::vector<model::Part> parts)
{
    PosedParts fine(source);
    pose::Workspace workspace(model.rig);
    const base::Span<const math::Affine> palette = workspace.pose(model::none, 0);
    fine.pose(model.rig, palette, workspace.weights());
    const std::vector<double> shares = zone_shares(model, source);
    Colours colours;
    std::vector<std::vector<Look>> looks;
    for (const model::Part &part : parts) {
        PosedParts coarse({&part});
        coarse.pose(model.rig, palette, workspace.weights());
        looks.emplace_back();
        const uint32_t shades = coarse.triangles().size() <= plain_triangles ? 1 : most_shades;
        const std::vector<Seen> seen = what_is_seen(model, fine, coarse);
        std::vector<ZoneAreas> areas;
        for (const Seen &one : seen) areas.push_back(one.areas);
        const std::vector<uint32_t> zones = chosen_zones(model, fine, coarse, areas, shares);
        const Usual usual(seen);
        for (size_t t = 0; t < seen.size(); ++t)
            looks.back().push_back(look_of(seen[t], zones[t], usual, shades, colours));
    }

    FarLevels far;
    far.zone_keys = keys_of(model);
    far.image.name = model.name + " far";
    far.image.alpha = model::AlphaMeaning::zone_keys;
    const uint32_t count = static_cast<uint32_t>(colours.sums.size());
    uint32_t rows = 1;
    while (rows * blocks_across < count) rows *= 2;
    far.image.width = block * blocks_across, far.image.height = block * rows;
    far.image.rgba.assign(4 * size_t(far.image.width) * far.image.height, 255);
    std::map<Look, glm::vec2> places;
    uint32_t at = 0;
    for (const auto &[look, sum] : colours.sums) {
        const uint32_t x = block * (at % blocks_across), y = block * (at / blocks_across);
        places[look] = {(float(x) + 0.5f * block) / float(far.image.width),
                        (float(y) + 0.5f * block) / float(far.image.height)};
        const glm::dvec3 colour = sum.first / std::max(sum.second, 1e-30);
        for (uint32_t i = 0; i < block * block; ++i) {
            uint8_t *texel = far.image.rgba.data() + 4 * ((y + i / block) * size_t(far.image.width) + x + i % block);
            for (int k = 0; k < 3; ++k)
                texel[k] = static_cast<uint8_t>(std::lround(255 * std::clamp(colour[k], 0.0, 1.0)));
            texel[3] = look.zone == model::none ? 255 : far.zone_keys[look.zone];
        }
        ++at;
    }
    // Texels that nobody points at show what the first does, so that none names a zone that there is not.
    for (uint32_t i = at; i < rows * blocks_across; ++i)
        for (uint32_t j = 0; j < block * block; ++j) {
            uint8_t *texel =
                far.image.rgba.data() + 4 * ((block * (i / blocks_across) + j / block) * size_t(far.image.width) +
                                             block * (i % blocks_across) + j % block);
            std::copy_n(far.image.rgba.data(), 4, texel);
        }
    far.material.name = far.image.name;
    far.material.image = static_cast<uint32_t>(model.images.size());
    far.material.wrap_s = far.material.wrap_t = model::Wrap::clamp;
    for (size_t i = 0; i < parts.size(); ++i) {
        give_uvs(parts[i], looks[i], places);
        parts[i].material = static_cast<uint32_t>(model.materials.size());
    }
    far.parts = std::move(parts);
    return far;
}

}  // namespace claque::lod
