// claque inspect: what a character is made of, as loaded and as split.
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>

#include "samples/cli/characters.h"
#include "samples/cli/command.h"
#include "samples/cli/inspect_nodes.h"
#include "samples/cli/track_arguments.h"

namespace cli
{
namespace
{

constexpr const char *topologies[] = {"points",    "lines",          "line loop",   "line strip",
                                      "triangles", "triangle strip", "triangle fan"};

Json clip_json(const clq_clip_info &clip)
{
    return {{"name", clip.name},
            {"start_s", clip.start_s},
            {"duration_s", clip.duration_s},
            {"channels", clip.channel_count}};
}

// Rounds lengths for reading; stored ones keep all digits.
double rounded(double value, double to) { return std::round(value / to) * to; }

Json sampled_clip_json(const clq_clip_info &clip)
{
    Json json = clip_json(clip);
    json["rate_hz"] = rounded(double(clip.rate_hz), 0.01);
    json["error_mm"] = rounded(double(clip.error) * 1000, 0.001);
    json["error_rad"] = rounded(double(clip.error_rad), 1e-5);
    json["kept"] = clip.kept_count;
    json["bytes"] = clip.bytes;
    return json;
}

Json asset_json(const clq_asset *asset)
{
    const clq_asset_info info = info_of(asset);
    Json json = {{"name", info.name},
                 {"parts", info.part_count},
                 {"hidden_parts", info.hidden_part_count},
                 {"triangles", info.triangle_count},
                 {"vertices", info.vertex_count},
                 {"nodes", info.node_count},
                 {"joints", info.joint_count},
                 {"max_influences", info.max_influences},
                 {"morph_targets", info.morph_target_count},
                 {"materials", info.material_count},
                 {"images", info.image_count},
                 {"box_min", info.box_min},
                 {"box_max", info.box_max}};
    json["part_list"] = Json::array();
    for (uint32_t i = 0; i < info.part_count; ++i) {
        clq_asset_part part = clq_asset_part_init();
        scenes::check(clq_asset_get_part(asset, i, &part));
        json["part_list"].push_back({{"name", part.name},
                                     {"node", part.node_name},
                                     {"material", part.material_name},
                                     {"topology", part.topology < 7 ? topologies[part.topology] : "?"},
                                     {"triangles", part.triangle_count},
                                     {"vertices", part.vertex_count},
                                     {"influences", part.influence_count},
                                     {"morph_targets", part.morph_target_count},
                                     {"skinned", part.skinned != 0},
                                     {"hidden", part.hidden != 0}});
    }
    json["clips"] = Json::array();
    for (uint32_t i = 0; i < info.clip_count; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        scenes::check(clq_asset_get_clip(asset, i, &clip));
        json["clips"].push_back(clip_json(clip));
    }
    json["warnings"] = Json::array();
    for (uint32_t i = 0; i < info.warning_count; ++i) json["warnings"].push_back(clq_asset_get_warning(asset, i));
    return json;
}

// Bytes of the clips against the same animation stored as meshes with a position and a normal for each vertex (S1 4):
// one mesh for each row of each clip (30 a second if no rate is known), and one for each frame at 25 a second, which
// is how meshes without interpolation are played.
Json motion_json(const clq_template_info &info, const Json &clips)
{
    uint64_t bytes = 0;
    double rows = 0, frames = 0;
    for (const Json &clip : clips) {
        const double length_s = clip["duration_s"].get<double>();
        const double rate = clip["rate_hz"].get<double>() > 0 ? clip["rate_hz"].get<double>() : 30;
        bytes += clip["bytes"].get<uint64_t>();
        rows += std::round(length_s * rate) + 1;
        frames += std::round(length_s * 25) + 1;
    }
    const double mesh = 24 * double(info.vertex_count);
    Json json = {{"bytes", bytes},
                 {"as_meshes_bytes", static_cast<uint64_t>(rows * mesh)},
                 {"as_meshes_25_hz_bytes", static_cast<uint64_t>(frames * mesh)}};
    if (bytes > 0) {
        json["times_less"] = std::round(rows * mesh / double(bytes) * 10) / 10;
        json["times_less_25_hz"] = std::round(frames * mesh / double(bytes) * 10) / 10;
    }
    return json;
}

Json template_json(const clq_template *tmpl)
{
    const clq_template_info info = info_of(tmpl);
    Json json = {{"name", info.name},
                 {"triangles", info.triangle_count},
                 {"clean", info.clean_count},
                 {"dirty", info.dirty_count},
                 {"dirty_zone_mean", info.dirty_zone_mean},
                 {"coincident", info.coincident_count},
                 {"fused_triangles", info.fused_triangle_count},
                 {"vertices", info.vertex_count},
                 {"fused_vertices", info.fused_vertex_count},
                 {"joints", info.joint_count},
                 {"max_influences", info.max_influences},
                 {"textures", info.texture_count},
                 {"surfaces", info.surface_count},
                 {"sklsroot_centre", info.sklsroot_centre},
                 {"sklsroot_radius", info.sklsroot_radius},
                 {"bytes", info.bytes}};
    json["zones"] = Json::array();
    for (uint32_t i = 0; i < info.zone_count; ++i) {
        clq_zone_info zone = clq_zone_info_init();
        scenes::check(clq_template_get_zone(tmpl, i, &zone));
        json["zones"].push_back({{"name", zone.name}, {"clean", zone.clean_count}, {"colour", zone.colour}});
    }
    json["clips"] = Json::array();
    for (uint32_t i = 0; i < info.clip_count; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        scenes::check(clq_template_get_clip(tmpl, i, &clip));
        json["clips"].push_back(sampled_clip_json(clip));
    }
    json["motion"] = motion_json(info, json["clips"]);
    return json;
}

void print_rows(const Json &rows, const char *heading)
{
    if (rows.empty()) return;
    std::cout << heading << "\n";
    for (const Json &row : rows) {
        std::cout << "  ";
        for (const auto &[key, value] : row.items()) {
            if (value.is_boolean()) {
                if (value.get<bool>()) std::cout << key << "  ";
            } else if (key == "name") std::cout << value.get<std::string>() << ":  ";
            else if (value.is_string() && !value.get<std::string>().empty())
                std::cout << key << " '" << value.get<std::string>() << "'  ";
            else if (!value.is_string() && !value.is_array()) std::cout << key << " " << value << "  ";
        }
        std::cout << "\n";
    }
}

void print_motion(const Json &motion)
{
    if (motion.empty() || !motion.contains("times_less")) return;
    std::cout << "clips take " << motion["bytes"] << " bytes; as meshes, one for each of their rows, "
              << motion["as_meshes_bytes"] << ": " << motion["times_less"] << " times as much; 25 a second, "
              << motion["as_meshes_25_hz_bytes"] << ": " << motion["times_less_25_hz"] << " times as much\n";
}

void print_text(const Json &report)
{
    std::cout << report["file"].get<std::string>() << "\n" << std::setprecision(4);
    for (const char *form : {"loaded", "split"}) {
        if (!report.contains(form)) continue;
        const Json &json = report[form];
        std::cout << form << "\n";
        for (const auto &[key, value] : json.items())
            if (!value.is_array() || (!value.empty() && value[0].is_number()))
                std::cout << "  " << key << " " << value << "\n";
    }
    if (report.contains("loaded")) {
        print_rows(report["loaded"]["part_list"], "parts");
        if (!report.contains("split")) print_rows(report["loaded"]["clips"], "clips");
    }
    if (report.contains("split")) {
        print_rows(report["split"]["zones"], "zones");
        print_rows(report["split"]["clips"], "clips");
        print_motion(report["split"]["motion"]);
    }
    if (report.contains("not_split")) std::cout << "not split: " << report["not_split"].get<std::string>() << "\n";
}

struct InspectArguments {
    std::string file;
    FileArguments of_file;
    ClipArguments clips;
    scenes::SocialClass walker;  // its nodes and clips, as options name them
    bool nodes = false, json = false;
};

bool tells_locomotion(const InspectArguments &a)
{
    const scenes::WalkingNodes &limbs = a.walker.limbs;
    const scenes::SocialClass::Clips &clips = a.walker.clips;
    return a.nodes || !limbs.legs.empty() || !clips.walk.empty() || !clips.idles.empty() ||
           !(limbs.torso + limbs.neck + limbs.head).empty();
}

void inspect(const InspectArguments &a)
{
    scenes::Library library(core_count());
    Json report = {{"file", a.file}};
    const auto split = [&](clq_template *tmpl) {
        report["split"] = template_json(tmpl);
        if (!tells_locomotion(a)) return;
        scenes::SocialClass walker = a.walker;
        walker.placement = a.of_file.placement;
        if (!a.clips.files.empty())
            walker.add_clips = [&](scenes::Library &of, clq_asset *asset) { add_clips(of, asset, a.clips); };
        add_locomotion(library, tmpl, walker, report);
    };
    if (is_prepared(a.file)) {
        const LoadedCharacter loaded = load_character(library, a.file);
        if (a.nodes) add_names(loaded.tmpl.get(), report);
        split(loaded.tmpl.get());
    } else {
        const scenes::Own<clq_asset> asset = load_asset(library, a.file, a.of_file, a.clips);
        report["loaded"] = asset_json(asset.get());
        if (a.nodes) add_names(asset.get(), report);
        clq_template *made = nullptr;
        const clq_asset_info info = info_of(asset.get());
        if (info.vertex_count == 0 && info.clip_count > 0)
            report["not_split"] = "clips alone: --clips " + a.file + " adds them to a character";
        else if (clq_asset_build(library.context(), asset.get(), 0, &made) == CLQ_OK)
            split(scenes::Own<clq_template>(made).get());
        else report["not_split"] = clq_last_error();  // points and lines load, but cannot be split
    }
    if (a.json) std::cout << report.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
    else print_text(report);
    if (!a.json) print_names(report);
}

}  // namespace

void add_inspect(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<InspectArguments>();
    CLI::App *c = app.add_subcommand("inspect", "Print what a character is made of");
    c->add_option("FILE", a->file,
                  "glTF, GLB, BVH, prepared .clq, or the name of a built-in character (citizen, patrician ...)")
        ->required();
    add_file_options(*c, a->of_file);
    add_clip_options(*c, a->clips);
    c->add_flag("--nodes", a->nodes,
                "Print the names of nodes, joints and materials too, and the legs and paces of a walker, or why it "
                "cannot walk; the options that name its nodes and clips print the latter alone");
    add_limb_options(*c, a->walker.limbs, a->walker.clips);
    c->add_flag("--json", a->json, "Print JSON");
    c->callback([a, &chosen] {
        a->walker.name = a->walker.character = a->file;
        chosen = [a] { inspect(*a); };
    });
}

}  // namespace cli
