#include "samples/cli/colour_arguments.h"

#include <filesystem>
#include <iostream>

#include "lib/base/near_names.h"
#include "samples/cli/characters.h"
#include "samples/cli/files.h"

namespace cli
{

CLI::Option *add_colours_option(CLI::App &command, std::string &file, scenes::Placement &placed,
                                const std::string &about)
{
    const auto take = [&file, &placed](const std::string &value) {
        const std::string near = claque::base::near_names(value, {"wild", "own"});
        if (value.find_first_of("./") == std::string::npos && !near.empty() && value != "wild" && value != "own" &&
            !std::filesystem::exists(value))
            throw CLI::ValidationError("--colours", "'" + value + "' is no file, and " + near);
        placed.colours = scenes::colours_of(value);
        file = placed.colours != CLQ_COLOURS_NEAR ? "" : value;
    };
    return command
        .add_option_function<std::string>(
            "--colours", take,
            about +
                "; wild: characters from files wear most hues, not colours near their files'; own: their files' own")
        ->type_name("FILE|wild|own");
}

void add_reload_option(CLI::App &command, bool &reload)
{
    command
        .add_flag("--reload", reload,
                  "Check the file of colours before every frame and apply it when it has changed; a broken file "
                  "changes nothing")
        ->needs(command.get_option("--colours"));
}

void wear_colours(scenes::SceneOptions &options, const std::string &file)
{
    if (file.empty()) return;
    expect_readable(file, io::most_text_bytes);  // early, as scenes take time
    options.make = [file, make = options.make, name = options.scene, character = options.character](
                       scenes::Library &library, const scenes::CrowdOptions &crowd_options) {
        std::unique_ptr<scenes::Scene> scene =
            make ? make(library, crowd_options) : scenes::make_scene(name, library, crowd_options, character);
        scenes::ColourFile(library, file).apply(*scene, crowd_options.seed);
        return scene;
    };
}

SceneColours::SceneColours(scenes::Library &library, const std::string &file, bool reload, uint64_t seed) : seed_(seed)
{
    if (!reload) return;
    if (file.empty())
        throw scenes::Failure("--reload needs a file of colours, which may change: --colours wild and own name none");
    file_.emplace(library, file);
}

void SceneColours::apply_to(const scenes::SceneRenderer &scene_renderer)
{
    if (!file_) return;
    try {
        file_->apply(scene_renderer.scene(), seed_);
    } catch (const scenes::Failure &broken) {
        std::cerr << "claque: colours are unchanged: " << broken.what() << '\n';
    }
}

void Worn::dress(clq_crowd *crowd, clq_actor actor) const
{
    if (map) scenes::check(clq_crowd_randomise_colours(crowd, map.get(), colour_class, &actor, 1));
}

std::vector<std::string> names_of_classes(const clq_colour_map *map)
{
    clq_colour_map_def def = clq_colour_map_def_init();
    scenes::check(clq_colour_map_get_def(map, &def));
    std::vector<std::string> names;
    for (uint32_t i = 0; i < def.class_count; ++i) names.emplace_back(def.classes[i].name);
    return names;
}

Worn worn_by(scenes::Library &library, const clq_template *tmpl, const std::string &file, const std::string &named)
{
    Worn worn;
    if (file.empty()) return worn;
    worn.map = scenes::read_colours(library, text_of(file), file);
    const std::string name = info_of(tmpl).name;
    worn.colour_class = scenes::class_for(worn.map.get(), named, name.c_str());
    if (!named.empty() && clq_colour_map_find(worn.map.get(), named.c_str()) == CLQ_NONE)
        throw scenes::Failure(file + ": has no class '" + named + "'" +
                              claque::base::names_near(named, names_of_classes(worn.map.get())));
    if (worn.colour_class == CLQ_NONE)
        throw scenes::Failure(file + ": has no class for the template '" + name + "'; --class NAME selects any");
    return worn;
}

}  // namespace cli
