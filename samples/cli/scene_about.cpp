#include "samples/cli/scene_about.h"

#include <filesystem>

#include "samples/cli/provenance.h"
#include "samples/io/regular_file.h"

namespace cli
{

Json file_about(const std::string &path)
{
    if (path.empty() || !std::filesystem::is_regular_file(path)) return path;
    return {{"file", std::filesystem::path(path).filename().string()}, {"sha256", sha256_of_file(path)}};
}

Json record_about(const std::string &path)
{
    constexpr uint64_t end_bytes = 1 << 20;
    const io::RegularFile file(path, io::most_record_bytes);
    if (!file.wrong().empty()) throw scenes::Failure(file.wrong());
    if (file.size() <= 2 * end_bytes) return file_about(path);
    std::string ends(2 * end_bytes, 0);
    if (!file.read(0, ends.data(), end_bytes) ||
        !file.read(file.size() - end_bytes, ends.data() + end_bytes, end_bytes))
        throw scenes::Failure(path + " became shorter while it was read");
    return {{"file", std::filesystem::path(path).filename().string()},
            {"bytes", file.size()},
            {"sha256_of_ends", sha256_of(ends.data(), ends.size())}};
}

Json scene_about(const SceneArguments &s, const scenes::SceneOptions &options)
{
    Json scene;
    scene["scene"] = options.scene, scene["file"] = file_about(s.file), scene["hidden"] = s.of_file.placement.hidden;
    const scenes::Placement &placed = s.of_file.placement;
    if (placed.any()) scene["placement"] = {placed.turn_deg, placed.height_m, placed.scale};
    if (placed.blend == CLQ_BLEND_OPAQUE) scene["blend"] = "opaque";
    scene["scenario"] = file_about(s.scenario), scene["path"] = file_about(s.path);
    if (s.described && !s.described->files.empty()) {
        scene["scenario_files"] = Json::array();
        for (const std::string &file : s.described->files) scene["scenario_files"].push_back(file_about(file));
    }
    scene["count"] = s.count, scene["seed"] = s.seed, scene["camera"] = s.camera, scene["hour"] = s.hour;
    scene["size_px"] = {options.width, options.height};
    scene["format"] = s.format, scene["filter"] = s.filter;
    if (s.multisample != 1) scene["multisample"] = s.multisample;
    if (s.close_mib != 0) scene["close_textures"] = {s.close_mib, s.close_distance_m};
    scene["cull"] = {s.cull, s.cull_scale};
    scene["shape"] = {s.rigid_mode, s.vertex_format};
    scene["levels"] = {s.lod, s.lod_scale, s.flat_triangles};
    scene["shadows"] = {s.shadows, s.blob_from_m};
    scene["show"] = s.show;
    scene["colours"] = placed.colours ? Json(scenes::name_of(placed.colours)) : file_about(s.colours);
    scene["key_poses"] = s.cache.rfind("keypose", 0) == 0 ? Json({s.cache, s.key_poses, s.key_pose_hz}) : Json();
    if (!s.made_of.is_null()) scene.update(s.made_of);
    return scene;
}

std::string difference(const Json &there, const Json &here)
{
    const Json a = there.flatten(), b = here.flatten();
    const auto word = [](const Json &all, const std::string &key) {
        return all.contains(key) ? all[key].dump() : std::string("missing");
    };
    for (const Json &all : {b, a})
        for (const auto &one : all.items())
            if (word(a, one.key()) != word(b, one.key()))
                return one.key() + " is " + word(a, one.key()) + " there and " + word(b, one.key()) + " here";
    return "their order differs";
}

}  // namespace cli
