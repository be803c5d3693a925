#include "samples/cli/film_about.h"

#include "samples/cli/provenance.h"
#include "samples/cli/scene_about.h"

namespace cli
{

Json film_scene(const RenderArguments &a, const scenes::SceneOptions &options)
{
    Json scene = scene_about(a.setup, options);
    scene["clips"] = Json::array();
    for (const std::string &file : a.clips.files) scene["clips"].push_back(file_about(file));
    if (!a.clip.empty()) scene["clip"] = a.clip;
    scene["vary"] = a.clips.vary, scene["fps"] = a.fps, scene["samples"] = a.samples;
    return scene;
}

Json film_about(const RenderArguments &a, const scenes::SceneOptions &options, const std::string &gl)
{
    const Json scene = a.scene.is_null() ? film_scene(a, options) : a.scene;
    const std::string text = scene.dump();
    Json about = {{"scene_hash", sha256_of(text.data(), text.size())}, {"scene", scene}};
    about.update(provenance(gl));
    return about;
}

}  // namespace cli
