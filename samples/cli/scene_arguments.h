// The options that `render` and `bench` share, and their form in text and JSON.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "samples/cli/cache_choice.h"
#include "samples/cli/characters.h"
#include "samples/scenes/scenario/scenario.h"
#include "samples/scenes/scene_renderer.h"

namespace cli
{

using Json = nlohmann::ordered_json;

using MakeScene = std::function<std::unique_ptr<scenes::Scene>(scenes::Library &, const scenes::CrowdOptions &)>;

struct SceneArguments {
    std::string file, scene;  // one or neither
    FileArguments of_file;
    std::string path, scenario;                         // files
    std::string colours;                                // likewise; empty: the scene's own
    std::string mechanisms;                             // the folder of --allow-mechanisms; empty: not given
    std::shared_ptr<const scenes::Scenario> described;  // the scenario, once it is read
    // People on tracks in place of the scenes above (track_arguments.h), and what they depend on.
    MakeScene make;
    Json made_of;
    std::string camera;  // empty: not given
    std::string context = "any", format = "rgba8888";
    std::string strategy = "fused", cache = "full", filter = "nearest";
    uint32_t count = 0;  // 0: not given
    uint64_t seed = 1, budget_mib = 0;
    int threads = 0;           // 0: as many as cores
    uint32_t key_poses = 256;  // kept for each template and level
    double key_pose_hz = 15;
    std::string cull = "actor", rigid_mode = "vertices", vertex_format = "float", show = "nothing";
    double cull_scale = 1;
    std::string lod = "on";            // of built-in people and of characters on tracks
    bool file_without_levels = false;  // --lod off was given: FILE has only levels of its own
    std::string shadows = "painted";
    double blob_from_m = 40;
    std::optional<uint32_t> flush_triangles;
    uint32_t flat_triangles = 64;
    double lod_scale = 1;
    double hour = 0;  // 0: not given
    uint32_t close_mib = 0;
    double close_distance_m = 0;
    int multisample = 1;

    int width = 1024, height = 768;
};

// Whether levels of detail are made for the character of FILE.
inline scenes::Lod levels_of_file(const SceneArguments &a)
{
    return a.file_without_levels ? scenes::Lod::off : scenes::Lod::on;
}

// --allow-mechanisms, for subcommands that read a scenario without the options below.
CLI::Option *add_mechanisms_option(CLI::App &command, std::string &folder);

// --scenario, for subcommands that take the name of a scene.
CLI::Option *add_scenario_option(CLI::App &command, SceneArguments &arguments);

// All other options except the scene's own argument, the file and `count`.
void add_scene_options(CLI::App &command, SceneArguments &arguments);

// --size WxH, stored in the two numbers, which hold the default on entry.
void add_size_option(CLI::App &command, int &width, int &height);

// Accepts the name of a scene.
CLI::IsMember scene_names();
std::string list_of_scenes();  // for sentences: plaza, odeon, ...

int thread_count(const SceneArguments &arguments);
int core_count();  // available to threads: [1, 256]

// Throws CLI::ValidationError unless a command has either the name of its scene or a scenario.
void expect_subject(const std::string &scene, const SceneArguments &arguments);
// Reads the scenario, if there is one. Throws scenes::Failure.
void read_scenario(SceneArguments &arguments);
// What makes its scene. A camera that is given replaces the scenario's own; follow:ID follows a person on tracks.
MakeScene maker_of(const SceneArguments &arguments);
// overview, close, path, at:PLACE, or follow:ID. Returns "", or a sentence that says what is wrong.
std::string check_camera(const std::string &text);
std::string viewpoint_of(const std::string &camera);  // the PLACE of at:PLACE; empty: it has no name
std::string followed_by(const std::string &camera);   // the ID of follow:ID; empty: it follows no person
// Throws CLI::ValidationError if the camera follows a person in a scene without tracks.
void expect_followed(const SceneArguments &arguments);
// Whether its people sit in a theatre.
bool is_theatre(const SceneArguments &arguments);
// The selected scene, and whether its camera moves along a path: one of its own, or --path.
std::string scene_of(const SceneArguments &arguments);
bool has_path(const SceneArguments &arguments);
// Throws CLI::ValidationError if options conflict, before any file but the scenario is read.
void check_scene_usage(const SceneArguments &arguments);

// Reads the files that options name. `loaded` must live as long as the scene that is made from this.
scenes::SceneOptions scene_options(const SceneArguments &arguments, const LoadedCharacter &loaded);

clq_draw_strategy strategy_named(const std::string &name);
const std::vector<std::string> &strategy_names();

const std::vector<std::string> &shadow_names();
scenes::ShadowChoice shadows_named(const std::string &name);
Json shadow_counters(const clq_shadow_stats &stats);

Json counters(const clq_crowd_stats &stats);
Json rates(const clq_crowd_stats &stats);  // the last band has no end: null
std::string hex(uint64_t hash);
std::string version();

}  // namespace cli
