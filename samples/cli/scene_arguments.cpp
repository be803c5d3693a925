#include "samples/cli/scene_arguments.h"

#include <thread>

#include "samples/cli/colour_arguments.h"
#include "samples/cli/files.h"
#include "samples/processes/machine_share.h"

namespace cli
{
void add_scene_options(CLI::App &command, SceneArguments &a)
{
    add_size_option(command, a.width, a.height);
    add_mechanisms_option(command, a.mechanisms);
    add_colours_option(command, a.colours, a.of_file.placement,
                       "Colours of people by class and zone (TOML, see `claque colours`) instead of the scene's own");
    command
        .add_option("--camera", a.camera,
                    "View of the scene: overview, close, path, a place of the amphitheatre (at:above, at:emperor, "
                    "at:top-row, at:arena), or on tracks follow:ID over a person's shoulder "
                    "(default overview; path if --path is given, or if the scene has a path and frames are requested)")
        ->check(CLI::Validator(check_camera, ""))
        ->type_name("VIEW");
    command.add_option("--hour", a.hour, "Hour of the day, in the amphitheatre: where its sun stands")
        ->check(CLI::Range(5.5, 18.5));
    command.add_option("--path", a.path, "Camera path to follow instead of the scene's own (TOML)")->type_name("FILE");
    command
        .add_option(
            "--context", a.context,
            "Source of OpenGL; any: what the variable CLAQUE_CONTEXT names, else OSMesa if it is there, else EGL; "
            "glx: the X server that DISPLAY names")
        ->check(CLI::IsMember({"any", "osmesa", "egl", "glx"}))
        ->capture_default_str();
    command.add_option("--format", a.format, "Pixel format of the drawing surface")
        ->check(CLI::IsMember({"rgba8888", "rgb565"}))
        ->capture_default_str();
    command
        .add_option("--multisample", a.multisample, "Samples a pixel of the drawing surface: smooth edges (1: none)")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    command
        .add_option("--rigid-mode", a.rigid_mode,
                    "Rigid parts by transformed vertices, or by OpenGL's matrix stack (S0 6.2.2)")
        ->check(CLI::IsMember({"vertices", "matrices"}))
        ->capture_default_str();
    command.add_option("--vertex-format", a.vertex_format, "Skinned vertices as floats, or packed into 12 bytes each")
        ->check(CLI::IsMember({"float", "packed"}))
        ->capture_default_str();
    command.add_option("--cache-mib", a.budget_mib, "Memory limit of the caches in MiB (0: 1024)")
        ->check(CLI::Range(0, 1 << 20));
    command
        .add_option("--key-poses", a.key_poses,
                    "For the caches keypose-*: key-poses kept for each template and level, if --cache names no number")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command.add_option("--key-pose-rate", a.key_pose_hz, "For the caches keypose-*: key-poses a second of each clip")
        ->check(CLI::Range(0.5, 120.0))
        ->capture_default_str();
    command
        .add_option(
            "--lod-scale", a.lod_scale,
            "Multiplies every distance that selects levels of detail: at 2 individuals look as from twice the distance")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    command
        .add_option("--flush", a.flush_triangles,
                    "Call glFlush after about this many triangles of people, so that GL starts on them (0: never; "
                    "default 16384 with EGL, never with OSMesa, where it copies the picture)")
        ->check(CLI::Range(0, 1 << 30));
    command
        .add_option("--flat", a.flat_triangles,
                    "Draw coarse levels of at most this many triangles with one colour a triangle (0: never)")
        ->check(CLI::Range(0, 2730))
        ->capture_default_str();
    command.add_option("--blob-from", a.blob_from_m, "With mesh shadows: ellipses from this distance on, in metres")
        ->check(CLI::Range(0.0, 1e9))
        ->capture_default_str();
    command.add_option("--seed", a.seed, "Seed of everything random")->capture_default_str();
    command
        .add_option("--threads", a.threads,
                    "Threads of the update, through oneTBB; may exceed the cores (default: the cores; 1 in a job of a "
                    "scheduler)")
        ->check(CLI::Range(1, 256));
}

CLI::IsMember scene_names()
{
    std::vector<std::string> names;
    for (const scenes::SceneEntry &entry : scenes::scene_entries()) names.push_back(entry.name);
    return CLI::IsMember(names);
}

std::string list_of_scenes()
{
    std::string names;
    for (const scenes::SceneEntry &entry : scenes::scene_entries())
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    return names;
}

int thread_count(const SceneArguments &a)
{
    return a.threads > 0 ? a.threads : processes::is_scheduled() ? 1 : core_count();
}

int core_count()
{
    const unsigned cores = std::thread::hardware_concurrency();
    return cores > 256 ? 256 : cores > 0 ? static_cast<int>(cores) : 1;
}

std::string scene_of(const SceneArguments &a)
{
    if (a.make) return "tracks";
    if (a.described) return a.described->name;
    return !a.file.empty() ? "parade" : !a.scene.empty() ? a.scene : "plaza";
}

void check_scene_usage(const SceneArguments &a)
{
    expect_followed(a);
    if (a.file.empty() && !a.described && !a.make) expect_files({}, a.of_file.placement);
    if (!a.path.empty() && !a.camera.empty() && a.camera != "path")
        throw CLI::ValidationError("--path", "the camera " + a.camera + " follows no path");
    if (a.camera == "path" && !has_path(a))
        throw CLI::ValidationError("--camera", "the scene " + scene_of(a) + " has no path of its own; use --path FILE");
    if (a.described && a.described->tracks && a.count > 0)
        throw CLI::ValidationError("--count", "the file of trajectories says how many people walk in " + scene_of(a));
}

scenes::SceneOptions scene_options(const SceneArguments &a, const LoadedCharacter &loaded)
{
    scenes::SceneOptions options;
    options.scene = scene_of(a);
    options.make = a.make;
    if (a.described && !a.make) options.make = maker_of(a);
    options.character = loaded.tmpl ? loaded.character() : scenes::Character();
    options.crowd_options.count = a.count;
    // A scenario has its own number of people.
    if (a.count == 0 && !a.described)
        for (const scenes::SceneEntry &entry : scenes::scene_entries())
            if (options.scene == entry.name) options.crowd_options.count = entry.default_count;
    options.crowd_options.hour = a.hour;
    options.crowd_options.seed = a.seed;
    options.crowd_options.cache = cache_named(a.cache);
    options.crowd_options.cache_budget_bytes = a.budget_mib << 20;
    options.crowd_options.key_poses.max_kept = a.key_poses;
    options.crowd_options.key_poses.rate_hz = static_cast<float>(a.key_pose_hz);
    take_key_poses(a.cache, options.crowd_options.key_poses);
    options.crowd_options.lod = a.lod == "off" ? scenes::Lod::off : scenes::Lod::on;
    options.crowd_options.lod_scale = a.lod == "finest" ? 0.0f : static_cast<float>(a.lod_scale);
    options.crowd_options.cull = a.cull == "traditional" ? CLQ_CULL_TRADITIONAL : CLQ_CULL_ACTOR;
    options.crowd_options.rigid_mode = a.rigid_mode == "matrices" ? CLQ_RIGID_MATRICES : CLQ_RIGID_VERTICES;
    options.crowd_options.vertex_format = a.vertex_format == "packed" ? CLQ_VERTEX_PACKED : CLQ_VERTEX_FLOAT;
    options.cull_scale = static_cast<float>(a.cull_scale);
    options.show = a.show == "spheres"  ? scenes::Show::spheres
                   : a.show == "levels" ? scenes::Show::levels
                                        : scenes::Show::nothing;
    options.shadows = shadows_named(a.shadows);
    options.shadows.blob_from_m = static_cast<float>(a.blob_from_m);
    options.shot = a.camera == "close"                     ? scenes::Shot::close
                   : a.camera == "path" || !a.path.empty() ? scenes::Shot::path
                                                           : scenes::Shot::overview;
    options.viewpoint = viewpoint_of(a.camera);
    if (!a.path.empty()) options.path.emplace(text_of(a.path), a.path);
    else if (options.shot == scenes::Shot::path && a.described) options.path = a.described->path;
    else if (options.shot == scenes::Shot::path)
        options.path.emplace(*scenes::recorded_path(options.scene), options.scene + "/path.toml");
    options.width = a.width, options.height = a.height;
    options.context = contexts::kind_named(a.context).value();
    options.format = a.format == "rgb565" ? contexts::PixelFormat::rgb565 : contexts::PixelFormat::rgba8888;
    options.strategy = strategy_named(a.strategy);
    options.flush_triangles = a.flush_triangles, options.flat_triangles = a.flat_triangles;
    options.linear_clean = a.filter == "linear", options.smooth_levels = a.filter == "levels";
    options.multisample = a.multisample;
    options.close_texture_bytes = uint64_t(a.close_mib) << 20;
    options.close_distance_m = static_cast<float>(a.close_distance_m);
    wear_colours(options, a.colours);
    return options;
}

const std::vector<std::string> &strategy_names()
{
    static const std::vector<std::string> names = {"per-zone", "binned", "fused"};
    return names;
}

clq_draw_strategy strategy_named(const std::string &name)
{
    return name == "per-zone" ? CLQ_STRATEGY_PER_ZONE : name == "binned" ? CLQ_STRATEGY_BINNED : CLQ_STRATEGY_FUSED;
}

const std::vector<std::string> &shadow_names()
{
    static const std::vector<std::string> names = {"painted", "none", "blob", "mesh", "blob-stencil", "mesh-stencil"};
    return names;
}

scenes::ShadowChoice shadows_named(const std::string &name)
{
    using Form = scenes::ShadowChoice::Form;
    scenes::ShadowChoice choice;
    choice.form = name.rfind("blob", 0) == 0   ? Form::blob
                  : name.rfind("mesh", 0) == 0 ? Form::mesh
                  : name == "none"             ? Form::none
                                               : Form::painted;
    choice.stencil = name.find("-stencil") != std::string::npos;
    return choice;
}

Json shadow_counters(const clq_shadow_stats &s)
{
    return {{"individuals", s.individuals}, {"blobs", s.blobs},      {"shadow_only", s.shadow_only}, {"draws", s.draws},
            {"triangles", s.triangles},     {"vertices", s.vertices}};
}

Json counters(const clq_crowd_stats &s)
{
    return {{"actors", s.actor_count},
            {"visible", s.visible},
            {"culled", s.actor_count - s.visible},
            {"due", s.due},
            {"animated", s.animated},
            {"skinned", s.skinned},
            {"palettes_from_cache", s.palette_served},
            {"vertices_from_cache", s.vertices_served},
            {"skinned_without_room", s.on_demand},
            {"evicted", s.evicted},
            {"cache_bytes", s.cache_bytes},
            {"cache_budget_bytes", s.cache_budget_bytes},
            {"actor_bytes", s.actor_bytes},
            {"groups", s.groups},
            {"groups_visible", s.groups_visible},
            {"tested", s.tested},
            {"passed_refpoint", s.passed_refpoint},
            {"passed_sklsroot", s.passed_sklsroot},
            {"crossing", s.crossing},
            {"sphere_tests", s.sphere_tests},
            {"spheres_built", s.spheres_built},
            {"roots_placed", s.roots_placed},
            {"distances", s.distances},
            {"matrices_needed", s.matrices_needed},
            {"matrices_built", s.matrices_built},
            {"products", s.products},
            {"products_tracked", s.products_tracked},
            {"behaviour_calls",
             {{"gaze", s.behaviour_calls[CLQ_MECHANISM_GAZE]},
              {"expression", s.behaviour_calls[CLQ_MECHANISM_EXPRESSION]},
              {"blink", s.behaviour_calls[CLQ_MECHANISM_BLINK]},
              {"phrase", s.behaviour_calls[CLQ_MECHANISM_PHRASE]},
              {"idle", s.behaviour_calls[CLQ_MECHANISM_IDLE]},
              {"host", s.behaviour_calls[CLQ_MECHANISM_HOST]}}},
            {"dof_writes", s.dof_writes}};
}

Json rates(const clq_crowd_stats &s)
{
    Json bands = Json::array();
    for (const clq_distance_band &band : s.bands) {
        if (band.actor_frames == 0) continue;
        bands.push_back(
            {{"distance_min_m", band.distance_min_m},
             {"distance_max_m", band.distance_max_m > band.distance_min_m ? Json(band.distance_max_m) : Json()},
             {"actor_frames", band.actor_frames},
             {"actor_seconds", band.seconds},
             {"animated", band.animated},
             {"rate_hz", band.seconds > 0 ? static_cast<double>(band.animated) / band.seconds : 0.0}});
    }
    return bands;
}

std::string hex(uint64_t hash)
{
    constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) text += digits[(hash >> shift) & 15];
    return text;
}

std::string version()
{
    return std::to_string(CLQ_VERSION_MAJOR) + "." + std::to_string(CLQ_VERSION_MINOR) + "." +
           std::to_string(CLQ_VERSION_PATCH);
}

}  // namespace cli
