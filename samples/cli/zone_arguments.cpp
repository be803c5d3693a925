#include "samples/cli/zone_arguments.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <utility>

#include "lib/base/near_names.h"
#include "samples/cli/characters.h"
#include "samples/cli/files.h"
#include "samples/cli/scene_arguments.h"
#include "samples/io/png.h"
#include "samples/scenes/check.h"
#include "samples/scenes/zone_inks.h"

namespace cli
{
namespace
{

using Rgb = scenes::Ink;
using scenes::hex_of;

// The zones of a map, by number: their keys on the command line, and the colours they are painted with.
struct Zones {
    uint32_t width = 0, height = 0;
    std::vector<uint16_t> texels;
    std::vector<std::string> keys;  // "#eeb28c" or "2"
    std::vector<Rgb> inks;
    std::vector<std::string> names;
};

// A colour of at least one texel in 2000 is a zone; other colours, as along soft edges, take the nearest zone.
// Transparent texels belong to no zone.
Zones read_painted(scenes::Library &library, const std::string &path)
{
    Zones out;
    clq_picture picture = clq_picture_init();
    scenes::check(clq_image_read(library.context(), path.c_str(), &picture), path);
    out.width = picture.width_px, out.height = picture.height_px;
    std::vector<uint8_t> rgba(4 * static_cast<size_t>(out.width) * out.height);
    picture.pixels = rgba.data(), picture.capacity_bytes = rgba.size();
    scenes::check(clq_image_read(library.context(), path.c_str(), &picture), path);
    std::map<Rgb, size_t> counts;
    const auto colour = [&](size_t i) { return Rgb{rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]}; };
    for (size_t i = 0; 4 * i < rgba.size(); ++i)
        if (rgba[4 * i + 3] >= 128) ++counts[colour(i)];
    std::map<Rgb, uint16_t> numbers;
    for (const auto &[rgb, count] : counts) {
        if (count * 2000 < rgba.size() / 4) continue;
        if (numbers.size() == 256)
            throw scenes::Failure(path + " is painted in more than 256 colours; each colour has to be a zone");
        numbers.emplace(rgb, static_cast<uint16_t>(numbers.size()));
        out.keys.push_back(hex_of(rgb));
        out.inks.push_back(rgb);
    }
    if (numbers.empty()) throw scenes::Failure(path + " has no colour that covers a two-thousandth of it");
    out.texels.assign(rgba.size() / 4, CLQ_NO_ZONE);
    for (size_t i = 0; i < out.texels.size(); ++i) {
        const auto found = numbers.find(colour(i));
        if (rgba[4 * i + 3] >= 128 && found != numbers.end()) out.texels[i] = found->second;
    }
    out.names = out.keys;
    return out;
}

Zones propose(const clq_asset *asset, const ZoneArguments &a)
{
    clq_asset_image image = clq_asset_image_init();
    scenes::check(clq_asset_get_image(asset, a.image, &image));
    Zones out;
    out.width = image.width_px, out.height = image.height_px;
    out.texels.resize(static_cast<size_t>(out.width) * out.height);
    std::vector<uint8_t> means(3 * static_cast<size_t>(a.propose));
    clq_zone_proposal proposal = clq_zone_proposal_init();
    proposal.max_zones = a.propose;
    proposal.texels = out.texels.data(), proposal.capacity_texels = out.texels.size();
    proposal.rgb = means.data();
    scenes::check(clq_asset_propose_zones(asset, a.image, &proposal));
    for (size_t i = 0; i < proposal.zone_count; ++i) {
        out.keys.push_back(std::to_string(i + 1));
        out.names.push_back("zone " + out.keys.back() + " " +
                            hex_of({means[3 * i], means[3 * i + 1], means[3 * i + 2]}));
        out.inks.push_back(scenes::zone_ink(i));
    }
    return out;
}

void name_zones(Zones &zones, const std::vector<std::string> &names)
{
    for (const std::string &given : names) {
        const size_t equals = given.find('=');
        std::string key = given.substr(0, equals);
        std::transform(key.begin(), key.end(), key.begin(), [](char c) { return c >= 'A' && c <= 'F' ? c + 32 : c; });
        const auto found = std::find(zones.keys.begin(), zones.keys.end(), key);
        if (equals == std::string::npos || equals + 1 == given.size())
            throw scenes::Failure("--zone " + given + " is not KEY=NAME, as in " + zones.keys[0] + "=skin");
        if (found == zones.keys.end()) {
            std::string all;
            for (const std::string &one : zones.keys) all += (all.empty() ? "" : ", ") + one;
            throw scenes::Failure("--zone " + given + ": there is no " + key + "; there are " + all);
        }
        zones.names[static_cast<size_t>(found - zones.keys.begin())] = given.substr(equals + 1);
    }
}

// Writes the image's current zones, each texel in its zone's ink, unpainted texels too. Read again, the map gives the
// same zones.
void write_map(const clq_asset *asset, const ZoneArguments &a, const Zones &zones)
{
    clq_asset_image image = clq_asset_image_init();
    scenes::check(clq_asset_get_image(asset, a.image, &image));
    std::array<Rgb, 256> ink_of_key{};
    const size_t texels = static_cast<size_t>(image.width_px) * image.height_px;
    const auto zone_at = [&](size_t i) {  // position in the map of the centre of an image texel
        const size_t x = (2 * (i % image.width_px) + 1) * zones.width / (2 * static_cast<size_t>(image.width_px));
        const size_t y = (2 * (i / image.width_px) + 1) * zones.height / (2 * static_cast<size_t>(image.height_px));
        return zones.texels[y * zones.width + x];
    };
    for (size_t i = 0; i < texels; ++i)
        if (zone_at(i) != CLQ_NO_ZONE) ink_of_key[image.rgba[4 * i + 3]] = zones.inks[zone_at(i)];
    std::vector<uint8_t> rgb;
    for (size_t i = 0; i < texels; ++i) {
        const Rgb &ink = ink_of_key[image.rgba[4 * i + 3]];
        rgb.insert(rgb.end(), ink.begin(), ink.end());
    }
    const std::vector<unsigned char> file =
        io::png(rgb.data(), static_cast<int>(image.width_px), static_cast<int>(image.height_px),
                {{"Software", "claque " + version()}});
    write_whole(a.map, file.data(), file.size());
}

std::vector<clq_zone_map_zone> painted_of(const Zones &zones, const std::vector<std::string> &reduced)
{
    for (const std::string &name : reduced)
        if (name != "all" && std::find(zones.names.begin(), zones.names.end(), name) == zones.names.end())
            throw scenes::Failure("--reduce " + name + ": no zone has that name" +
                                  claque::base::names_near(name, zones.names));
    std::vector<clq_zone_map_zone> out;
    for (const std::string &name : zones.names) {
        const auto asked = [&](const std::string &one) { return one == "all" || one == name; };
        out.push_back({name.c_str(), std::any_of(reduced.begin(), reduced.end(), asked), nullptr});
    }
    return out;
}

}  // namespace

void add_zone_options(CLI::App &c, ZoneArguments &a)
{
    c.add_option("--image", a.image, "Name of the file's image that gets zones")->capture_default_str();
    CLI::Option *painted =
        c.add_option("--zones", a.painted, "Zones painted over the image in a PNG of any size, one colour each");
    CLI::Option *proposed =
        c.add_option("--propose", a.propose, "Propose at most this many zones from the image's colours")
            ->check(CLI::Range(1, 48));
    painted->excludes(proposed);
    c.add_option("--zone", a.names,
                 "Name a zone: '#eeb28c=skin' by its painted colour, '2=skin' by its proposed number")
        ->expected(1)
        ->take_all();
    c.add_option("--reduce", a.reduced,
                 "Reduce the zone of this name, or all, to light and dark, so that it takes any colour")
        ->expected(1)
        ->take_all();
    c.add_option("--zones-out", a.map, "Write the zones as a PNG, to be corrected and read again with --zones");
}

ZoneMap give_zones(scenes::Library &library, clq_asset *asset, const ZoneArguments &a)
{
    ZoneMap map;
    if (a.painted.empty() && a.propose == 0) {
        if (!a.names.empty() || !a.reduced.empty() || !a.map.empty())
            throw scenes::Failure("--zone, --reduce and --zones-out need --zones or --propose");
        return map;
    }
    const clq_asset_info info = info_of(asset);
    if (info.image_count == 0)
        throw scenes::Failure(std::string("--zones and --propose divide a picture, and '") + info.name +
                              "' has none: its zones are its materials (" + std::to_string(info.material_count) + ")");
    if (!a.map.empty()) expect_writable(a.map);
    Zones zones = a.painted.empty() ? propose(asset, a) : read_painted(library, a.painted);
    name_zones(zones, a.names);
    map.zones = painted_of(zones, a.reduced);
    map.def.image = a.image;
    map.def.width_px = zones.width, map.def.height_px = zones.height;
    map.def.texels = zones.texels.data();
    map.def.zone_count = static_cast<uint32_t>(map.zones.size());
    map.def.zones = map.zones.data();
    scenes::check(clq_asset_set_zone_map(library.context(), asset, &map.def));
    if (!a.map.empty()) write_map(asset, a, zones);
    std::fprintf(stderr, "%-9s %7s  %s\n", "zone", "picture", "name");
    for (size_t i = 0; i < zones.keys.size(); ++i) {
        const size_t texels = static_cast<size_t>(std::count(zones.texels.begin(), zones.texels.end(), i));
        std::fprintf(stderr, "%-9s %5.1f %%  %s%s\n", zones.keys[i].c_str(),
                     100.0 * static_cast<double>(texels) / static_cast<double>(zones.texels.size()),
                     zones.names[i].c_str(), map.zones[i].reduced ? ", light and dark" : "");
    }
    map.texels = std::move(zones.texels), map.names = std::move(zones.names);  // which keep their addresses
    return map;
}

}  // namespace cli
