// --scenario: reading it, and what follows from it for other options.
#include "samples/cli/scene_arguments.h"

namespace cli
{

CLI::Option *add_scenario_option(CLI::App &command, SceneArguments &a)
{
    return command
        .add_option("--scenario", a.scenario,
                    "A scene that a file describes: who sits or walks, where, in which light (TOML, docs/scenarios.md)")
        ->type_name("FILE");
}

void expect_subject(const std::string &scene, const SceneArguments &a)
{
    if (scene.empty() && a.scenario.empty()) throw CLI::ValidationError("SCENE", "is required, or --scenario FILE");
    if (!scene.empty() && !a.scenario.empty())
        throw CLI::ValidationError("--scenario", "is a scene of its own; leave out " + scene);
}

void read_scenario(SceneArguments &a)
{
    if (!a.scenario.empty()) a.described = std::make_shared<const scenes::Scenario>(scenes::load_scenario(a.scenario));
}

bool is_theatre(const SceneArguments &a) { return a.described ? a.described->theatre.has_value() : a.scene == "odeon"; }

bool has_path(const SceneArguments &a)
{
    if (!a.path.empty()) return true;
    return a.described ? a.described->path.has_value() : scenes::recorded_path(scene_of(a)) != nullptr;
}

MakeScene maker_of(const SceneArguments &a)
{
    scenes::Scenario shown = *a.described;
    if (!a.camera.empty()) shown.follow.clear();
    return [kept = std::make_shared<const scenes::Scenario>(std::move(shown))](
               scenes::Library &library, const scenes::CrowdOptions &crowd_options) {
        return scenes::make_scenario(library, crowd_options, *kept);
    };
}

}  // namespace cli
