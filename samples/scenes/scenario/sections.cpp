#include "samples/scenes/scenario/sections.h"

namespace scenes
{

const std::vector<ScenarioSection> &scenario_sections()
{
    static const std::vector<ScenarioSection> all = {
        {"characters", read_characters}, {"theatre", read_theatre}, {"tracks", read_tracks},
        {"stage", read_staging},         {"town", read_town},       {"places", read_places},
        {"navigation", read_navigation}, {"doors", read_doors},     {"agents", read_agents},
        {"flyers", read_flyers},         {"people", read_people},   {"camera", read_camera},
        {"light", read_light},           {"ground", read_ground},
    };
    return all;
}

std::string file_of(TomlTable &table, const char *key, const ScenarioFiles &files)
{
    const std::string name = table.text(key);
    if (name.empty()) table.refuse("has '" + std::string(key) + "' = \"\", which names no file", key);
    const std::string path = name.front() == '/' ? name : files.folder + name;
    const std::string wrong = files.find(path);
    if (!wrong.empty()) table.refuse("names a file in '" + std::string(key) + "' that cannot be read: " + wrong, key);
    return path;
}

}  // namespace scenes
