#include "samples/cli/film_about.h"

#include <filesystem>

#include "samples/cli/provenance.h"

namespace cli
{
namespace
{

// The name of a built-in character is no file.
Json file_of(const std::string &path)
{
    if (path.empty() || !std::filesystem::is_regular_file(path)) return path;
    return {{"file", std::filesystem::path(path).filename().string()}, {"sha256", sha256_of_file(path)}};
}

}  // namespace

Json film_about(const RenderArguments &a, const scenes::SceneOptions &options, const std::string &gl)
{
    const SceneArguments &s = a.setup;
    Json scene;
    scene["scene"] = options.scene, scene["file"] = file_of(s.file), scene["hidden"] = s.hidden;
    scene["scenario"] = file_of(s.scenario), scene["path"] = file_of(s.path);
    scene["colours"] = file_of(a.colours.file), scene["clips"] = Json::array();
    for (const std::string &file : a.clips.files) scene["clips"].push_back(file_of(file));
    if (s.described && !s.described->files.empty()) {
        scene["scenario_files"] = Json::array();
        for (const std::string &file : s.described->files) scene["scenario_files"].push_back(file_of(file));
    }
    scene["vary"] = a.clips.vary;
    scene["count"] = s.count, scene["seed"] = s.seed, scene["camera"] = s.camera;
    scene["size_px"] = {options.width, options.height};
    scene["fps"] = a.fps, scene["samples"] = a.samples, scene["format"] = s.format, scene["filter"] = s.filter;
    if (s.close_mib != 0) scene["close_textures"] = {s.close_mib, s.close_distance_m};
    scene["cull"] = {s.cull, s.cull_scale};
    scene["shape"] = {s.rigid_mode, s.vertex_format};
    scene["levels"] = {s.lod, s.lod_scale, s.flat_triangles};
    scene["shadows"] = {s.shadows, s.blob_from_m};
    scene["show"] = s.show;
    scene["key_poses"] = s.cache.rfind("keypose", 0) == 0 ? Json({s.cache, s.key_poses, s.key_pose_hz}) : Json();
    const std::string text = scene.dump();
    Json about = {{"scene_hash", sha256_of(text.data(), text.size())}, {"scene", scene}};
    about.update(provenance(gl));
    return about;
}

}  // namespace cli
