#include "samples/scenes/scene.h"

#include "lib/base/near_names.h"

namespace scenes
{

void warn_of_likeness(Library &library, const clq_template *tmpl)
{
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    clq_clip_info clip = clq_clip_info_init();
    for (uint32_t i = 0; i < info.clip_count; ++i)
        if (clq_template_get_clip(tmpl, i, &clip) != CLQ_OK || clip.duration_s > 0) return;
    const std::string who = std::string("'") + info.name + "' has no clip" +
                            (info.clip_count > 0 ? " longer than 0 s" : ""),
                      clips = "--clips FILE adds clips, --clips citizen those of the built-in citizen";
    const std::string sentence =
        info.zone_count > 1 ? who + ", so its crowd stands alike: " + clips
                            : who + " and one zone, so its crowd looks alike: " + clips +
                                  ", and --colours wild, or a zone map of its picture (claque prepare --propose N), "
                                  "colours that differ";
    clq_context_log(library.context(), CLQ_LOG_WARNING, sentence.c_str());
}

const std::vector<SceneEntry> &scene_entries()
{
    static const std::vector<SceneEntry> entries = {
        {"plaza", "citizens on a Roman plaza: talking, walking, applauding a speaker", make_plaza, 400},
        {"odeon", "three classes of Roman society in a theatre", make_odeon, 1020},
        {"multitude", "ten thousand on a field: applauding, cheering, laughing, waving or idle (S3 5)", make_multitude,
         10000},
        {"ten_thousand", "the same field with all four people in chains of levels of detail, all individuals in view",
         make_ten_thousand, 10000},
        {"amphitheatre", "the Flavian Amphitheatre with 50 000 spectators, an awning, and the sun by the hour",
         make_amphitheatre, 50000},
        {"parade", "rows of one character on a plain ground, playing its clips in turn", make_parade, 12},
        {"vehicle", "omnibuses full of people on the streets of a small town, each a group", make_vehicle, 320, true},
        {"town_sky", "heralds that fly over a small town, with flight, gaze, expressions, blinking and phrases",
         make_town_sky, 2000, true},
        {"hundred_actors", "a hundred dragons over a lake, culled as Table 2 of S0 says", make_hundred_actors, 100,
         true},
        {"everything", "figures that have what a renderer may meet: a test of other renderers", make_everything, 9},
    };
    return entries;
}

std::unique_ptr<Scene> make_scene(const std::string &name, Library &library, const CrowdOptions &crowd_options,
                                  const Character &character)
{
    if (character.tmpl && crowd_options.count > 1) warn_of_likeness(library, character.tmpl);
    std::vector<std::string> names;
    for (const SceneEntry &entry : scene_entries()) {
        if (name == entry.name) return entry.make(library, crowd_options, character);
        names.emplace_back(entry.name);
    }
    throw Failure("there is no scene '" + name + "'" + claque::base::names_near(name, names));
}

}  // namespace scenes
