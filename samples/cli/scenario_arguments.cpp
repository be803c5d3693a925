// --scenario: reading it, and what follows from it for other options.
#include "samples/cli/scene_arguments.h"

namespace cli
{

CLI::Option *add_mechanisms_option(CLI::App &command, std::string &folder)
{
    return command
        .add_option("--allow-mechanisms", folder,
                    "Let a scenario's people load shared objects, which are programs, from this folder and below "
                    "(docs/scenarios.md)")
        ->check(CLI::ExistingDirectory)
        ->type_name("FOLDER");
}

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
    if (a.scenario.empty()) return;
    auto described = std::make_shared<scenes::Scenario>(scenes::load_scenario(a.scenario, a.mechanisms));
    // For characters of files whose class does not say it.
    const scenes::Placement &given = a.of_file.placement;
    for (scenes::SocialClass &one : described->characters) {
        if (!scenes::is_file(one.character)) continue;
        scenes::Placement own = one.placement.is_placed() ? one.placement : given;
        own.blend = one.placement.blend ? one.placement.blend : given.blend;
        own.colours = one.placement.colours ? one.placement.colours : given.colours;
        own.hidden = given.hidden;
        one.placement = own;
    }
    expect_files(described->characters, given);
    a.described = described;
}

bool is_theatre(const SceneArguments &a) { return a.described ? a.described->theatre.has_value() : a.scene == "odeon"; }

bool has_path(const SceneArguments &a)
{
    if (!a.path.empty()) return true;
    return a.described ? a.described->path.has_value() : scenes::recorded_path(scene_of(a)) != nullptr;
}

std::string followed_by(const std::string &camera)
{
    const std::string follow = "follow:";
    return camera.rfind(follow, 0) == 0 ? camera.substr(follow.size()) : "";
}

std::string viewpoint_of(const std::string &camera)
{
    const std::string at = "at:";
    return camera.rfind(at, 0) == 0 ? camera.substr(at.size()) : "";
}

std::string check_camera(const std::string &text)
{
    for (const char *name : {"overview", "close", "path"})
        if (text == name) return {};
    if (!followed_by(text).empty() || !viewpoint_of(text).empty()) return {};
    return "'" + text + "' is no camera: overview, close, path, at:PLACE or follow:ID";
}

void expect_followed(const SceneArguments &a)
{
    if (followed_by(a.camera).empty() || a.make || (a.described && a.described->tracks)) return;
    throw CLI::ValidationError("--camera", a.camera + " needs people on tracks: --scenario FILE with [tracks]");
}

MakeScene maker_of(const SceneArguments &a)
{
    scenes::Scenario shown = *a.described;
    if (!a.camera.empty()) shown.follow = followed_by(a.camera), shown.follow_at = "--camera " + a.camera;
    return [kept = std::make_shared<const scenes::Scenario>(std::move(shown))](
               scenes::Library &library, const scenes::CrowdOptions &crowd_options) {
        return scenes::make_scenario(library, crowd_options, *kept);
    };
}

}  // namespace cli
