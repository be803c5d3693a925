#include "lib/asset/zone_map.h"

#include <algorithm>
#include <cmath>

#include "lib/asset/near_colours.h"
#include "lib/asset/zone_ranges.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;
using model::none;

namespace
{

using Rgb = std::array<float, 3>;

double luminance(const uint8_t *rgb) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

// The materials that show an image in any texture set.
std::vector<uint32_t> users_of(const model::Model &model, uint32_t image)
{
    std::vector<uint32_t> users;
    for (uint32_t i = 0; i < model.materials.size(); ++i) {
        bool shows = model.materials[i].image == image;
        for (const model::TextureSet &set : model.texture_sets) shows = shows || set.images[i] == image;
        if (shows) users.push_back(i);
    }
    return users;
}

void check(const model::Model &model, uint32_t image, const ZoneMap &map, size_t zone_count)
{
    if (image >= model.images.size())
        fail(CLQ_ARGUMENT, "image %u does not exist: '%s' has %zu", image, model.name.c_str(), model.images.size());
    if (zone_count > 256) fail(CLQ_LIMIT, "%zu zones for one image: 256 are the most", zone_count);
    if (map.width == 0 || map.height == 0 || !map.zones)
        fail(CLQ_ARGUMENT, "a zone map of %u x %u texels", map.width, map.height);
    bool any = false;
    for (size_t i = 0; i < size_t(map.width) * map.height; ++i) {
        any = any || map.zones[i] != unknown_zone;
        if (map.zones[i] != unknown_zone && map.zones[i] >= zone_count)
            fail(CLQ_ARGUMENT, "texel (%zu, %zu) of the zone map names zone %u, which does not exist: there are %zu",
                 i % map.width, i / map.width, map.zones[i], zone_count);
    }
    if (!any) fail(CLQ_ARGUMENT, "the zone map of %u x %u texels names no zone anywhere", map.width, map.height);
    const std::vector<uint32_t> users = users_of(model, image);
    if (users.empty()) fail(CLQ_ARGUMENT, "no material shows image %u '%s'", image, model.images[image].name.c_str());
    for (const uint32_t user : users)
        if (model.materials[user].alpha_mode == model::AlphaMode::mask)
            fail(CLQ_ARGUMENT,
                 "material '%s' is cut out by the alpha of image %u '%s', which has no room for zone keys: divide "
                 "another image (--image), or colour its zone as a whole (docs/colours.md)",
                 model.materials[user].name.c_str(), image, model.images[image].name.c_str());
}

// The zone at the centre of each texel of an image.
std::vector<uint16_t> known_texels(const ZoneMap &map, uint32_t width, uint32_t height)
{
    std::vector<uint16_t> zones(size_t(width) * height);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const uint64_t u = (2 * uint64_t(x) + 1) * map.width / (2 * uint64_t(width));
            const uint64_t v = (2 * uint64_t(y) + 1) * map.height / (2 * uint64_t(height));
            zones[y * width + x] = map.zones[v * map.width + u];
        }
    return zones;
}

// Unknown texels take the zone that first spreads to them from known ones.
std::vector<uint16_t> texels_of(const ZoneMap &map, std::vector<uint16_t> zones, uint32_t width, uint32_t height)
{
    std::vector<uint32_t> front, next;
    for (uint32_t at = 0; at < zones.size(); ++at)
        if (zones[at] != unknown_zone) front.push_back(at);
    // A map with known texels may have none at these centres.
    if (front.empty()) {
        for (size_t i = 0; i < size_t(map.width) * map.height; ++i)
            if (map.zones[i] != unknown_zone) return std::vector<uint16_t>(zones.size(), map.zones[i]);
    }
    for (; !front.empty(); front.swap(next)) {
        next.clear();
        for (const uint32_t at : front) {
            const uint32_t x = at % width, y = at / width;
            const auto spread = [&](bool inside, uint32_t to) {
                if (!inside || zones[to] != unknown_zone) return;
                zones[to] = zones[at];
                next.push_back(to);
            };
            spread(x > 0, at - 1), spread(x + 1 < width, at + 1);
            spread(y > 0, at - width), spread(y + 1 < height, at + width);
        }
    }
    return zones;
}

// The luminance below which 49 of 50 texels of a zone lie; at least 1.
double top_of(const model::Image &image, const std::vector<uint16_t> &zones, uint16_t zone)
{
    std::array<size_t, 256> counts{};
    size_t all = 0;
    for (size_t i = 0; i < zones.size(); ++i)
        if (zones[i] == zone) ++counts[static_cast<size_t>(luminance(&image.rgba[4 * i]) + 0.5)], ++all;
    size_t below = 0;
    for (size_t y = 0; y < 256; ++y)
        if ((below += counts[y]) * 50 >= all * 49) return std::max<double>(1, double(y));
    return 255;
}

// Makes a zone's texels grey. Returns the colour that restores the look of the known ones best (least squares, by
// channel): others may be shown nowhere.
Rgb reduce(model::Image &image, const std::vector<uint16_t> &zones, const std::vector<uint16_t> &known, uint16_t zone)
{
    const bool is_known = std::find(known.begin(), known.end(), zone) != known.end();
    const double top = top_of(image, is_known ? known : zones, zone);
    double squares = 0, products[3] = {0, 0, 0};
    for (size_t i = 0; i < zones.size(); ++i) {
        if (zones[i] != zone) continue;
        uint8_t *texel = &image.rgba[4 * i];
        const double grey = std::floor(std::min(255.0, 255 * luminance(texel) / top) + 0.5);
        const double weight = is_known && known[i] != zone ? 0 : grey;
        squares += weight * grey;
        for (int k = 0; k < 3; ++k) products[k] += weight * texel[k];
        std::fill_n(texel, 3, static_cast<uint8_t>(grey));
    }
    Rgb colour = {1, 1, 1};
    for (size_t k = 0; k < 3 && squares > 0; ++k) colour[k] = static_cast<float>(std::min(1.0, products[k] / squares));
    return colour;
}

// If all materials of an image have one base colour, multiplies it into the texels of all their texture sets. Otherwise
// it would still tint reduced zones.
void fold_base_colour(model::Model &next, uint32_t image)
{
    std::vector<uint32_t> users = users_of(next, image), images = {image};
    for (const model::TextureSet &set : next.texture_sets)
        for (const uint32_t user : users)
            if (set.images[user] != none) images.push_back(set.images[user]);
    for (const uint32_t user : users) images.push_back(next.materials[user].image);
    std::sort(images.begin(), images.end());
    images.erase(std::unique(images.begin(), images.end()), images.end());
    const std::array<float, 4> base = next.materials[users[0]].base_colour;
    for (const uint32_t one : images)
        for (const uint32_t user : users_of(next, one))
            if (next.materials[user].base_colour != base || std::find(users.begin(), users.end(), user) == users.end())
                return;
    for (const uint32_t user : users) next.materials[user].base_colour = {1, 1, 1, base[3]};
    for (const uint32_t one : images)
        for (size_t i = 0; i < next.images[one].rgba.size(); ++i) {
            uint8_t &value = next.images[one].rgba[i];
            if (i % 4 != 3)
                value = static_cast<uint8_t>(std::clamp(double(value) * double(base[i % 4]), 0.0, 255.0) + 0.5);
        }
}

bool keyed(const model::Model &model, const model::Material &material)
{
    return material.image != none && model.images[material.image].alpha == model::AlphaMeaning::zone_keys;
}

// The zones that texels or materials show.
std::vector<bool> shown_zones(const model::Model &model)
{
    std::array<bool, 256> keys{};
    for (const model::Image &image : model.images)
        if (image.alpha == model::AlphaMeaning::zone_keys)
            for (size_t i = 3; i < image.rgba.size(); i += 4) keys[image.rgba[i]] = true;
    std::vector<bool> shown(model.zones.size()), named(model.zones.size());
    for (const model::Material &material : model.materials)
        if (!keyed(model, material) && material.zone != none) shown[material.zone] = named[material.zone] = true;
    for (size_t z = 0; z < model.zones.size(); ++z) shown[z] = shown[z] || (!named[z] && keys[model.zones[z].key]);
    return shown;
}

void drop_unused_zones(model::Model &model)
{
    const std::vector<bool> shown = shown_zones(model);
    std::vector<uint32_t> to(model.zones.size(), none);
    std::vector<model::Zone> kept;
    for (size_t z = 0; z < model.zones.size(); ++z)
        if (shown[z]) to[z] = static_cast<uint32_t>(kept.size()), kept.push_back(model.zones[z]);
    model.zones = std::move(kept);
    for (model::Material &material : model.materials)
        if (material.zone != none) material.zone = to[material.zone];
}

// The key of a zone of the map: that of the keyed zone with its name, or else the lowest free key.
uint8_t key_for(model::Model &next, const ZoneMapZone &painted, const Rgb &colour)
{
    std::vector<bool> named(next.zones.size());
    for (const model::Material &material : next.materials)
        if (!keyed(next, material) && material.zone != none) named[material.zone] = true;
    std::array<bool, 256> taken{};
    for (size_t z = 0; z < next.zones.size(); ++z) {
        if (named[z]) continue;
        if (next.zones[z].name == painted.name) return next.zones[z].key;
        taken[next.zones[z].key] = true;
    }
    const auto free = std::find(taken.begin(), taken.end(), false);
    if (free == taken.end()) fail(CLQ_LIMIT, "'%s' has more zones than keys", next.name.c_str());
    model::Zone zone;
    zone.name = painted.name;
    zone.key = static_cast<uint8_t>(free - taken.begin());
    zone.colour = colour;
    zone.range = painted.range ? *painted.range
                               : default_range(painted.name, zone.colour,
                                               painted.reduced ? Texturing::untextured : Texturing::textured);
    next.zones.push_back(zone);
    return zone.key;
}

// The names of zones with keys.
std::vector<std::string> keyed_zones(const model::Model &model)
{
    const std::vector<bool> of_materials = material_zones(model);
    std::vector<std::string> names;
    for (size_t z = 0; z < model.zones.size(); ++z)
        if (!of_materials[z]) names.push_back(model.zones[z].name);
    return names;
}

// The zones to which neither the map nor an earlier one gave a range.
std::vector<bool> open_zones(const model::Model &next, const std::vector<std::string> &before,
                             const std::vector<ZoneMapZone> &painted)
{
    std::vector<bool> open = material_zones(next);
    for (const ZoneMapZone &one : painted) {
        if (one.range || std::find(before.begin(), before.end(), one.name) != before.end()) continue;
        for (size_t z = 0; z < open.size(); ++z) open[z] = open[z] || next.zones[z].name == one.name;
    }
    return open;
}

// Lends a model's rig and parts to another for as long as it lives.
class Lent
{
public:
    Lent(model::Model &from, model::Model &to) : from_(from), to_(to) { swap(); }
    ~Lent() { swap(); }
    Lent(const Lent &) = delete;
    Lent &operator=(const Lent &) = delete;

private:
    void swap() { std::swap(from_.rig, to_.rig), from_.parts.swap(to_.parts); }

    model::Model &from_, &to_;
};

}  // namespace

void set_zone_map(model::Model &model, uint32_t image, const ZoneMap &map, const std::vector<ZoneMapZone> &zones,
                  Colours colours)
{
    check(model, image, map, zones.size());
    model::Model next;
    next.name = model.name;
    next.zones = model.zones, next.materials = model.materials, next.texture_sets = model.texture_sets;
    next.images = model.images;
    const std::vector<uint32_t> users = users_of(next, image);
    fold_base_colour(next, image);
    model::Image &texels = next.images[image];
    const std::vector<uint16_t> known = known_texels(map, texels.width, texels.height),
                                wanted = texels_of(map, known, texels.width, texels.height);
    // The materials now have zone keys, so their own zones may be removed.
    texels.alpha = model::AlphaMeaning::zone_keys;
    for (const uint32_t user : users)
        if (next.materials[user].image == image) next.materials[user].zone = none;
    for (size_t i = 3; i < texels.rgba.size(); i += 4) texels.rgba[i] = 0;
    for (size_t z = 0; z < zones.size(); ++z) {
        if (std::find(wanted.begin(), wanted.end(), z) == wanted.end()) continue;
        const Rgb colour = zones[z].reduced ? reduce(texels, wanted, known, static_cast<uint16_t>(z)) : Rgb{1, 1, 1};
        const uint8_t key = key_for(next, zones[z], colour);
        for (size_t i = 0; i < wanted.size(); ++i)
            if (wanted[i] == z) texels.rgba[4 * i + 3] = key;
    }
    drop_unused_zones(next);
    if (colours != Colours::wild) {
        const std::vector<bool> open = open_zones(next, keyed_zones(model), zones);
        const Lent lent(model, next);
        give_ranges(next, open, colours);
    }
    model.zones = std::move(next.zones), model.materials = std::move(next.materials);
    model.images = std::move(next.images);
}

}  // namespace claque::asset
