#include "samples/cli/inspect_nodes.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>

#include "samples/scenes/template_names.h"
#include "samples/scenes/walkers/cast.h"

namespace cli
{
namespace
{

Json name_or_null(const clq_template *tmpl, uint32_t node)
{
    return node == CLQ_NONE ? Json() : Json(clq_template_get_node_name(tmpl, node));
}

Json leg_json(const clq_template *tmpl, const clq_leg_def &leg)
{
    return {{"thigh", name_or_null(tmpl, leg.thigh)},
            {"shin", name_or_null(tmpl, leg.shin)},
            {"foot", name_or_null(tmpl, leg.foot)},
            {"toes", name_or_null(tmpl, leg.toes)}};
}

double rounded(float length) { return std::round(double(length) * 1000) / 1000; }

Json gait_json(const std::vector<std::string> &clips, uint32_t clip, float stride, float speed)
{
    if (clip == CLQ_NONE) return nullptr;
    return {{"clip", clips[clip]}, {"stride", rounded(stride)}, {"speed", rounded(speed)}};
}

void print_parts(const char *what, const Json &parts)
{
    std::cout << "  " << what;
    for (const auto &[key, value] : parts.items())
        if (!value.is_null())
            std::cout << "  " << key << " " << value.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::cout << "\n";
}

// As a tree, each below its parent.
void print_nodes(const Json &nodes)
{
    struct Open {
        size_t node, depth;
    };
    std::vector<std::vector<size_t>> below(nodes.size());
    std::vector<Open> open;
    for (size_t i = nodes.size(); i-- > 0;) {  // what is opened last is printed first
        const Json parent = nodes[i].value("parent", Json());
        if (parent.is_null()) open.push_back({i, 1});
        else below[parent.get<size_t>()].push_back(i);
    }
    while (!open.empty()) {
        const Open at = open.back();
        open.pop_back();
        const Json &node = nodes[at.node];
        std::cout << std::string(2 * std::min<size_t>(at.depth, 50), ' ') << node["name"].get<std::string>()
                  << (node.value("joint", false) ? "  joint" : "") << "\n";
        for (const size_t child : below[at.node]) open.push_back({child, at.depth + 1});
    }
}

void print_locomotion(const Json &found)
{
    if (found.contains("why_not")) {
        std::cout << "no locomotion: " << found["why_not"].get<std::string>() << "\n";
        return;
    }
    std::cout << "locomotion, in units of the file and seconds\n";
    for (const char *what : {"left_leg", "right_leg", "upper", "walk", "run", "slow_walk"})
        if (!found[what].is_null()) print_parts(what, found[what]);
    for (const Json &clip : found["idles"]) print_parts("idle", {{"clip", clip}});
}

}  // namespace

void add_names(const clq_asset *asset, Json &report)
{
    const clq_asset_info info = info_of(asset);
    report["node_list"] = Json::array();
    for (uint32_t i = 0; i < info.node_count; ++i) {
        clq_asset_node node = clq_asset_node_init();
        scenes::check(clq_asset_get_node(asset, i, &node));
        report["node_list"].push_back({{"name", node.name},
                                       {"parent", node.parent == CLQ_NONE ? Json() : Json(node.parent)},
                                       {"joint", node.joint}});
    }
    std::vector<std::string> materials;
    std::set<std::pair<std::string, uint32_t>> morphs;  // the parts of a mesh share theirs
    report["morph_list"] = Json::array();
    for (uint32_t i = 0; i < info.part_count; ++i) {
        clq_asset_part part = clq_asset_part_init();
        scenes::check(clq_asset_get_part(asset, i, &part));
        if (std::find(materials.begin(), materials.end(), part.material_name) == materials.end())
            materials.emplace_back(part.material_name);
        for (uint32_t k = 0; k < part.morph_target_count; ++k)
            if (morphs.emplace(part.node_name, k).second)
                report["morph_list"].push_back(
                    {{"node", part.node_name}, {"target", k}, {"name", clq_asset_get_morph_name(asset, i, k)}});
    }
    report["material_list"] = materials;
}

void add_names(const clq_template *tmpl, Json &report)
{
    report["node_list"] = Json::array();
    for (const std::string &name : scenes::names_of_nodes(tmpl)) report["node_list"].push_back({{"name", name}});
}

void add_locomotion(scenes::Library &library, clq_template *tmpl, const scenes::SocialClass &described, Json &report)
{
    scenes::walkers::Member member;
    member.described = described;
    member.tmpl = tmpl;
    try {
        // With the gaits that it borrows where it walks on tracks.
        if (scenes::is_file(described.character) && !is_prepared(described.character)) {
            member.own = scenes::walkers::template_of_file(library, described);
            member.tmpl = tmpl = member.own.get();
        }
        const scenes::walkers::GaitClips gaits = scenes::walkers::gait_clips(member);
        const scenes::walkers::OwnLocomotion made = scenes::walkers::locomotion_of(library, member);
        clq_locomotion_info info = clq_locomotion_info_init();
        scenes::check(clq_locomotion_get_info(made.get(), &info));
        const std::vector<std::string> clips = scenes::names_of_clips(tmpl);
        Json idles = Json::array();
        for (const uint32_t idle : gaits.idles) idles.push_back(clips[idle]);
        report["locomotion"] = {{"left_leg", leg_json(tmpl, info.legs[0])},
                                {"right_leg", leg_json(tmpl, info.legs[1])},
                                {"upper",
                                 {{"torso", name_or_null(tmpl, info.torso)},
                                  {"neck", name_or_null(tmpl, info.neck)},
                                  {"head", name_or_null(tmpl, info.head)}}},
                                {"leg_length", rounded(info.leg_length)},
                                {"walk", gait_json(clips, gaits.walk, info.walk_stride, info.walk_speed)},
                                {"run", gait_json(clips, gaits.run, info.run_stride, info.run_speed)},
                                {"slow_walk", gait_json(clips, gaits.slow_walk, info.slow_stride, info.slow_speed)},
                                {"idles", idles}};
    } catch (const scenes::Failure &why) {
        report["locomotion"] = {{"why_not", why.what()}};
    }
}

void print_names(const Json &report)
{
    if (report.contains("node_list")) {
        std::cout << "nodes\n";
        print_nodes(report["node_list"]);
    }
    if (report.contains("material_list")) std::cout << "materials\n";
    if (report.contains("material_list"))
        for (const Json &name : report["material_list"]) std::cout << "  " << name.get<std::string>() << "\n";
    if (!report.value("morph_list", Json()).empty()) {
        std::cout << "morph targets\n";
        for (const Json &one : report["morph_list"])
            std::cout << "  " << one["node"].get<std::string>() << " " << one["target"] << "  "
                      << one["name"].get<std::string>() << "\n";
    }
    if (report.contains("locomotion")) print_locomotion(report["locomotion"]);
}

}  // namespace cli
