// Prepared templates, TOML and zone maps for `claque bench readers`.
#include <claque/claque.h>
#include <claque/colour_files.h>
#include <claque/zones.h>

#include <cmath>
#include <cstring>

#include "samples/cli/joint_map.h"
#include "samples/cli/reader_parts.h"
#include "samples/scenes/scenario/scenario.h"

namespace cli
{
namespace other_readers
{
namespace
{

using scenes::check;
using scenes::Own;

// For readers of the samples, which throw.
template <class Work>
std::string thrown_of(const Work &work)
{
    try {
        work();
        return "ok";
    } catch (const std::exception &) {
        return "refused";
    }
}

// What a file is built into; "" where reading or building refuses it.
template <std::string (*gltf)(uint32_t)>
std::string prepared(uint32_t count)
{
    const scenes::Library library(1);
    const std::string bytes = gltf(count);
    clq_asset *read = nullptr;
    if (clq_asset_load(library.context(), bytes.data(), bytes.size(), nullptr, &read) != CLQ_OK) return "";
    const Own<clq_asset> asset(read);
    clq_template *made = nullptr;
    if (clq_asset_build(library.context(), read, 0, &made) != CLQ_OK) return "";
    const Own<clq_template> tmpl(made);
    std::string out;
    check(clq_template_save(made, append_bytes, &out));
    return out;
}

Reading read_prepared(scenes::Library &library, const std::string &bytes)
{
    if (bytes.empty()) return {0, 0, "not built", "-"};
    return timed([&] {
        clq_template *made = nullptr;
        const clq_status status = clq_template_load(library.context(), bytes.data(), bytes.size(), &made);
        clq_template_destroy(made);
        return outcome_of(status);
    });
}

std::string colour_classes(uint32_t count)
{
    std::string text;
    for (uint32_t i = 0; i < count; ++i) text += "[[classes]]\nname = \"c" + std::to_string(i) + "\"\n";
    return text;
}

constexpr const char *one_range = " = { hue = [0, 90], saturation = [0, 1], brightness = [0, 1] }\n";

std::string colour_zones(uint32_t count)
{
    std::string text = "[[classes]]\nname = \"c\"\n[classes.zones]\n";
    for (uint32_t i = 0; i < count; ++i) text += "z" + std::to_string(i) + one_range;
    return text;
}

std::string colour_entries(uint32_t count)
{
    std::string text = "[[classes]]\nname = \"c\"\n[classes.zones]\nz = { palette = [";
    for (uint32_t i = 0; i < count; ++i) text += "{ colour = \"#2a1a10\" }, ";
    return text + "] }\n";
}

std::string comments(uint32_t count)
{
    std::string text = colour_classes(1);
    for (uint32_t i = 0; i < count; ++i) text += "# " + std::to_string(i) + "\n";
    return text;
}

Reading read_colours(scenes::Library &library, const std::string &bytes)
{
    return timed([&] {
        clq_colour_map *made = nullptr;
        const clq_status status = clq_colour_map_load(library.context(), bytes.data(), bytes.size(), nullptr, &made);
        clq_colour_map_destroy(made);
        return outcome_of(status);
    });
}

std::string map_joints(uint32_t count)
{
    std::string text = "[joints]\n";
    for (uint32_t i = 0; i < count; ++i) text += "a" + std::to_string(i) + " = \"b" + std::to_string(i) + "\"\n";
    return text;
}

Reading read_map(scenes::Library &, const std::string &bytes)
{
    return timed([&] { return thrown_of([&] { read_joint_map(bytes, "map"); }); });
}

std::string path_keys(uint32_t count)
{
    std::string text = "far_m = 900.0\n[[sections]]\nname = \"all\"\nstart_s = 0.0\nend_s = 1.0\n";
    for (uint32_t i = 0; i < std::max(count, 2u); ++i)
        text += "[[keys]]\ntime_s = " + std::to_string(i) + ".0\neye = [" + std::to_string(i % 9) +
                ".0, 2.0, 0.0]\ntarget = [0.0, 0.0, 30.0]\nfov_deg = 54.0\nnear_m = 1.0\n";
    return text;
}

Reading read_path(scenes::Library &, const std::string &bytes)
{
    return timed([&] { return thrown_of([&] { const scenes::CameraPath path(bytes, "path"); }); });
}

constexpr const char *scenario_head = "name = \"x\"\n[tracks]\nfile = \"x.csv\"\n";

std::string scenario_classes(uint32_t count)
{
    std::string text = scenario_head;
    for (uint32_t i = 0; i < count; ++i)
        text += "[[characters]]\nname = \"c" + std::to_string(i) + "\"\ncharacter = \"citizen\"\n";
    return text;
}

std::string scenario_zones(uint32_t count)
{
    std::string text = scenario_classes(1) + "[characters.palette]\n";
    for (uint32_t i = 0; i < count; ++i) text += "z" + std::to_string(i) + one_range;
    return text;
}

// `count` rows of a class of one person, each adjoining the last, and what else is in the theatre.
std::string theatre_of(uint32_t count, const std::string &more)
{
    std::string text =
        "name = \"x\"\n[[characters]]\nname = \"c\"\ncharacter = \"citizen\"\ncount = 1\n"
        "[theatre.orchestra]\nradius_m = 6.2\n[theatre.seats]\nwidth_m = 0.65\nfacing_noise_deg = 7\n"
        "[theatre.stage]\nfront_z_m = 9\ndepth_m = 5\nhalf_width_m = 13\nfloor_y_m = 1\nwall_height_m = 9\n";
    for (uint32_t i = 0; i < count; ++i)
        text += "[[theatre.rows]]\ncount = 1\nradius_m = " + std::to_string(6.9 + 0.8 * i) +
                "\ndepth_m = 0.8\nseat_y_m = " + std::to_string(0.86 + 0.43 * i) +
                "\nrise_m = 0.43\nsweep_deg = [-90, 90]\nclass = \"c\"\n";
    return text + more;
}

std::string scenario_rows(uint32_t count) { return theatre_of(count, ""); }

std::string scenario_gangways(uint32_t count)
{
    std::string angles;
    for (uint32_t i = 0; i < count; ++i) angles += std::to_string(i % 20) + ".0, ";
    return theatre_of(1, "[[theatre.gangways]]\nwidth_m = 0.5\nrows = [1, 1]\nat_deg = [" + angles + "]\n");
}

std::string scenario_walkways(uint32_t count)
{
    std::string walkways;
    for (uint32_t i = 0; i < count; ++i)
        walkways += "[[theatre.walkways]]\ninner_m = 20\nouter_m = 21\ny_m = " + std::to_string(i % 50) + "\n";
    return theatre_of(1, walkways);
}

Reading read_scenario_text(scenes::Library &, const std::string &bytes)
{
    const auto there = [](const std::string &) { return std::string(); };
    return timed([&] { return thrown_of([&] { scenes::read_scenario(bytes, "scenario", {"", {}, there}); }); });
}

// The texels of a map of one image; its zones alternate.
Reading read_zone_map(scenes::Library &library, const std::string &bytes)
{
    const Own<clq_asset> asset = asset_of(library, gltf_with_pixels(10000));
    clq_zone_map_def def = clq_zone_map_def_init();
    const uint32_t texels = static_cast<uint32_t>(bytes.size() / 2);
    std::vector<uint16_t> zones(texels);
    std::memcpy(zones.data(), bytes.data(), 2 * size_t(texels));
    const clq_zone_map_zone names[] = {{"one", true, nullptr}, {"two", false, nullptr}};
    def.width_px = texels, def.height_px = 1;
    def.texels = zones.data(), def.zone_count = 2, def.zones = names;
    return timed([&] { return outcome_of(clq_asset_set_zone_map(library.context(), asset.get(), &def)); });
}

std::string zone_texels(uint32_t count)
{
    std::string bytes(2 * size_t(count), '\0');
    for (uint32_t i = 0; i < count; ++i) bytes[2 * size_t(i)] = char(i / 3 % 2);
    return bytes;
}

Reading read_proposal(scenes::Library &library, const std::string &bytes)
{
    const Own<clq_asset> asset = asset_of(library, bytes);
    clq_asset_image image = clq_asset_image_init();
    check(clq_asset_get_image(asset.get(), 0, &image));
    std::vector<uint16_t> texels(size_t(image.width_px) * image.height_px);
    std::vector<uint8_t> rgb(3 * 8);
    clq_zone_proposal proposal = clq_zone_proposal_init();
    proposal.max_zones = 8, proposal.texels = texels.data(), proposal.capacity_texels = texels.size();
    proposal.rgb = rgb.data();
    return timed([&] { return outcome_of(clq_asset_propose_zones(asset.get(), 0, &proposal)); });
}

}  // namespace
}  // namespace other_readers

std::vector<ReaderElement> reader_elements_of_others()
{
    using namespace other_readers;
    return {{"prepared", "nodes", most_elements, prepared<gltf_with_nodes>, read_prepared},
            {"prepared", "triangles", most_elements, prepared<gltf_with_triangles>, read_prepared},
            {"prepared", "keys", most_elements, prepared<gltf_with_keys>, read_prepared},
            {"prepared", "channels", 1000, prepared<gltf_with_channels>, read_prepared},
            {"prepared", "animations", most_elements, prepared<gltf_with_animations>, read_prepared},
            {"prepared", "markers", 4096, prepared<gltf_with_markers>, read_prepared},
            {"prepared", "morph targets", 65535, prepared<gltf_with_morph_targets>, read_prepared},
            {"prepared", "degrees of freedom", most_elements, prepared<gltf_with_degrees_of_freedom>, read_prepared},
            {"colours", "classes", 256, colour_classes, read_colours},
            {"colours", "zones of a class", 255, colour_zones, read_colours},
            {"colours", "entries of a palette", 64, colour_entries, read_colours},
            {"colours", "lines of comment", most_elements, comments, read_colours},
            {"joints", "joints of a map", most_elements, map_joints, read_map},
            {"path", "keys", 40000, path_keys, read_path},
            {"scenario", "classes", 64, scenario_classes, read_scenario_text},
            {"scenario", "zones of a class", most_elements, scenario_zones, read_scenario_text},
            {"scenario", "rows", 100, scenario_rows, read_scenario_text},
            {"scenario", "gangways", most_elements, scenario_gangways, read_scenario_text},
            {"scenario", "walkways", 40000, scenario_walkways, read_scenario_text},
            {"zones", "texels of a map", 65536, zone_texels, read_zone_map},
            {"zones", "texels of a proposal", most_elements, gltf_with_pixels, read_proposal}};
}

}  // namespace cli
