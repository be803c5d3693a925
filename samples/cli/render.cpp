// claque render: one picture of a scene, or a sequence.
#include <cmath>
#include <optional>
#include <unistd.h>

#include "samples/cli/colour_arguments.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/filtering.h"
#include "samples/cli/measured_rates.h"
#include "samples/cli/png.h"
#include "samples/cli/progress.h"
#include "samples/cli/scene_arguments.h"
#include "samples/cli/sequence.h"
#include "samples/cli/stopwatch.h"

namespace cli
{
namespace
{

struct RenderArguments {
    SceneArguments setup;
    ColourArguments colours;
    ClipArguments clips;  // for the scene's FILE
    double time_s = 2.0, fps = 25.0;
    std::string frames, out, json;
    FrameRange range;
    bool whole_path = false;  // frames up to the path's last key frame
    bool again = false;
    uint32_t samples = 1;  // pictures that are averaged into one
};

struct Frame {
    int number;  // -1: the single picture of --time
    double time_s;
    std::string path;
};

std::vector<Frame> planned(const RenderArguments &a, const scenes::SceneOptions &options)
{
    if (a.frames.empty()) return {{-1, a.time_s, a.out}};
    std::vector<Frame> frames;
    FrameRange range = a.range;
    if (a.whole_path) range.last = static_cast<int>(options.path->end_s() * a.fps);
    for (int number : frames_of(range)) frames.push_back({number, number / a.fps, frame_path(a.out, number)});
    return frames;
}

bool finished(const RenderArguments &a, const scenes::SceneOptions &options, const Frame &frame)
{
    return frame.number >= 0 && !a.again && frame.path != "-" &&
           is_whole_png(frame.path, options.width, options.height);
}

Words words_about(const scenes::SceneOptions &options, const scenes::SceneRenderer &scene_renderer, double time_s)
{
    char time[32];
    std::snprintf(time, sizeof time, "%.6g", time_s);
    return {{"Software", "claque " + version()},
            {"Description", options.scene + ", " + std::to_string(scene_renderer.crowd_stats().actor_count) +
                                " individuals, seed " + std::to_string(options.crowd_options.seed) + ", time " + time +
                                " s"},
            {"Source", scene_renderer.context_name()}};
}

Json draw(scenes::SceneRenderer &scene_renderer, const scenes::SceneOptions &options, const Frame &frame,
          uint32_t samples)
{
    const Stopwatch updating;
    scene_renderer.update(frame.time_s);
    const double update_ms = updating.ms();
    const Stopwatch environment;
    scene_renderer.draw_environment();
    scene_renderer.gl().Finish();
    const double environment_ms = environment.ms();
    const Stopwatch darkening;
    const clq_shadow_stats darkened = scene_renderer.draw_shadows();
    const double shadow_ms = darkening.ms();
    const Stopwatch drawing;
    const clq_draw_stats drawn = scene_renderer.draw_crowd();
    const double draw_ms = drawing.ms();
    scene_renderer.draw_show();
    const std::vector<uint8_t> &rgb =
        samples > 1 ? scene_renderer.picture(frame.time_s, samples) : scene_renderer.read();
    if (frame.path == "-") write_whole("-", rgb.data(), rgb.size());
    else {
        const std::vector<unsigned char> file =
            png(rgb.data(), options.width, options.height, words_about(options, scene_renderer, frame.time_s));
        write_whole(frame.path, file.data(), file.size());
    }
    const clq_view_stats seen = scene_renderer.view_stats();
    Json report;
    if (frame.number >= 0) report["frame"] = frame.number;
    report["time_s"] = frame.time_s;
    if (frame.path != "-") report["file"] = frame.path;
    report["picture_hash"] = hex(scenes::hash_of(rgb));
    report["list_hash"] = hex(scene_renderer.view_hash());
    report["update_ms"] = update_ms;
    report["environment_ms"] = environment_ms;
    report["draw_ms"] = draw_ms;
    report["drawn"] = {{"individuals", drawn.individuals},
                       {"draws", drawn.draws},
                       {"triangles_seen", seen.triangles},
                       {"triangles_sent", drawn.triangles},
                       {"vertices_sent", drawn.vertices}};
    if (options.shadows.form != scenes::ShadowChoice::Form::painted)
        report["shadows"] = shadow_counters(darkened), report["shadow_ms"] = shadow_ms;
    report["counters"] = counters(scene_renderer.crowd_stats());
    return report;
}

Json about(const RenderArguments &a, const scenes::SceneOptions &options)
{
    Json report;
    report["claque"] = version();
    report["scene"] = options.scene;
    if (!a.setup.file.empty()) report["file"] = a.setup.file;
    report["seed"] = options.crowd_options.seed;
    report["size_px"] = {options.width, options.height};
    report["camera"] = options.shot == scenes::Shot::path    ? "path"
                       : options.shot == scenes::Shot::close ? "close"
                                                             : "overview";
    if (!a.setup.path.empty()) report["path"] = a.setup.path;
    if (!a.setup.theatre.empty()) report["theatre"] = a.setup.theatre;
    if (!a.colours.file.empty()) report["colours"] = a.colours.file;
    report["strategy"] = a.setup.strategy;
    report["cache"] = a.setup.cache;
    report["threads"] = thread_count(a.setup);
    return report;
}

void render(const RenderArguments &a)
{
    Progress progress("claque");
    expect_writable(frame_path(a.out, 0));
    if (!a.json.empty()) expect_writable(a.json);

    scenes::Library library(thread_count(a.setup));
    LoadedCharacter loaded;
    scenes::SceneOptions options = scene_options(a.setup, loaded);
    std::vector<Frame> frames;
    Json report = about(a, options);
    report["skipped"] = Json::array();
    for (Frame &frame : planned(a, options)) {
        if (finished(a, options, frame)) report["skipped"].push_back(frame.number);
        else frames.push_back(std::move(frame));
    }

    SceneColours wardrobe(library, a.colours, options.crowd_options.seed);
    std::optional<scenes::SceneRenderer> scene_renderer;
    report["frames"] = Json::array();
    for (size_t i = 0; i < frames.size(); ++i) {
        if (!scene_renderer) {
            progress.phase("preparing");
            if (!a.setup.file.empty()) loaded = load_character(library, a.setup.file, a.setup.hidden, a.clips);
            options = scene_options(a.setup, loaded);
            scene_renderer.emplace(library, options);
            report["count"] = scene_renderer->crowd_stats().actor_count;
            report["context"] = scene_renderer->context_name();
        }
        wardrobe.apply_to(*scene_renderer);
        report["frames"].push_back(draw(*scene_renderer, options, frames[i], a.samples));
        progress.step(i + 1, frames.size());
    }
    if (!a.json.empty()) {
        progress.phase("measuring rates");
        if (scene_renderer && options.linear_clean) report["filtering"] = filtering(*scene_renderer);
        if (scene_renderer) report["measured"] = measured_rates(*scene_renderer, frames.back().time_s);
        report["warnings"] = library.warnings();
        write_whole(a.json, report.dump(2) + "\n");
    }
    progress.conclude(a.out + ": " + std::to_string(frames.size()) + " drawn" +
                      (scene_renderer ? ", " + std::to_string(scene_renderer->crowd_stats().actor_count) +
                                            " individuals, " + scene_renderer->context_name()
                                      : ""));
}

void check_usage(RenderArguments &a)
{
    if ((!a.clips.files.empty() || a.clips.vary > 0) && a.setup.file.empty())
        throw CLI::ValidationError("--clips", "and --vary need a FILE, the character that gets the clips");
    check_scene_usage(a.setup);
    if (!a.frames.empty()) {
        if (a.setup.camera.empty() && has_path(a.setup)) a.setup.camera = "path";
        a.whole_path = a.frames == "all";
        if (a.whole_path && a.setup.camera != "path")
            throw CLI::ValidationError("--frames", "all needs a camera that follows a path");
        const std::string wrong = a.whole_path ? "" : read_range(a.frames, a.range);
        if (!wrong.empty()) throw CLI::ValidationError("--frames", wrong);
        if (a.out != "-" && !is_frame_pattern(a.out))
            throw CLI::ValidationError("--out",
                                       "a sequence needs one place for the frame number, as in frame-%05d.png");
    } else if (a.out != "-" && a.out.find('%') != std::string::npos)
        throw CLI::ValidationError("--out", "a place for the frame number needs --frames");
    if (!std::isfinite(a.time_s)) throw CLI::ValidationError("--time", "must be finite");
    if (!(a.fps > 0 && a.fps <= 1e6)) throw CLI::ValidationError("--fps", "must be above 0");
    if (a.out == "-" && a.json == "-")
        throw CLI::ValidationError("--json", "standard output is used by the pictures already");
    if (a.out == "-" && isatty(STDOUT_FILENO) == 1)
        throw CLI::ValidationError("--out", "raw pixels cannot go to a terminal; send them to a file or an encoder");
}

}  // namespace

void add_render(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<RenderArguments>();
    CLI::App *c = app.add_subcommand("render", "Draw a scene, one picture or a sequence");
    std::string abouts;
    for (const scenes::SceneEntry &entry : scenes::scene_entries())
        abouts += std::string(abouts.empty() ? "" : "; ") + entry.name + ": " + entry.about;
    CLI::Option *file = c->add_option("FILE", a->setup.file,
                                      "Stand this character on a ground: glTF, GLB, prepared .clq, or the name of a "
                                      "built-in character (citizen, patrician ...)");
    c->add_option("--scene", a->setup.scene, "A scene of built-in characters (default plaza). " + abouts)
        ->check(scene_names())
        ->excludes(file);
    c->add_option("--count", a->setup.count, "Individuals (default 12 of a FILE, else the scene's own number)")
        ->check(CLI::Range(1, 1000000));
    add_scene_options(*c, a->setup);
    add_colour_options(*c, a->colours);
    add_clip_options(*c, a->clips);
    c->add_option("--strategy", a->setup.strategy,
                  "Draw strategy: how individuals get their colours; all give the same picture")
        ->check(CLI::IsMember(strategy_names()))
        ->capture_default_str();
    c->add_option("--cache", a->setup.cache,
                  "What is cached between frames, which never changes the picture; keypose-*: all individuals show "
                  "key-poses (S3)")
        ->check(cache_choice)
        ->capture_default_str();
    c->add_option("--filter", a->setup.filter,
                  "How textures are sampled; linear filters clean triangles where that mixes no zones")
        ->check(CLI::IsMember({"nearest", "linear"}))
        ->capture_default_str();
    c->add_option("--lod", a->setup.lod,
                  "On the plaza and in the odeon: people with levels of detail (on), without (off), or only the first "
                  "level (finest)")
        ->check(CLI::IsMember({"off", "on", "finest"}))
        ->capture_default_str();
    c->add_option(
         "--cull", a->setup.cull,
         "Cull between the steps of behaviour (actor), or compute everything for all and cull last (traditional; S0 4)")
        ->check(CLI::IsMember({"actor", "traditional"}))
        ->capture_default_str();
    c->add_option("--cull-scale", a->setup.cull_scale,
                  "Cull by a frustum of this fraction of the picture's and show its edge (S0 Fig. 10)")
        ->check(CLI::Range(0.01, 1.0));
    c->add_option("--show", a->setup.show,
                  "Overlay spheres: the actors' bounding spheres (S0 Fig. 2); or levels: a colour for each level of "
                  "detail (S0 Fig. 9)")
        ->check(CLI::IsMember({"nothing", "spheres", "levels"}));
    c->add_option("--shadows", a->setup.shadows,
                  "Shadows of people on the ground: as painted, or claque's ellipses (blob) or meshes; -stencil: with "
                  "a stencil bit")
        ->check(CLI::IsMember(shadow_names()));
    CLI::Option *time = c->add_option("--time", a->time_s, "Time of the picture in seconds")->capture_default_str();
    c->add_option("--frames", a->frames,
                  "A sequence, first to last, or all of a camera path; frame k shows k / fps seconds")
        ->type_name("A:B|all")
        ->excludes(time);
    c->add_option("--stride", a->range.stride, "Draw only every N-th frame")
        ->check(CLI::Range(1, 1000000))
        ->needs("--frames");
    c->add_option("--fps", a->fps, "Frames a second of a sequence")->capture_default_str()->needs("--frames");
    c->add_option(
         "--samples", a->samples,
         "Anti-aliasing: the mean of this many pictures of the same poses, each moved by a fraction of a pixel")
        ->check(CLI::Range(1, 1024));
    c->add_flag("--again", a->again, "Draw finished frames again")->needs("--frames");
    c->add_option("--out,-o", a->out,
                  "PNG file; with --frames a pattern like f-%05d.png; - streams raw RGB, rows from the top")
        ->required();
    c->add_option("--json", a->json, "Write counts, rates and times as JSON; - is standard output");
    c->callback([a, &chosen] {
        check_usage(*a);
        chosen = [a] { render(*a); };
    });
}

}  // namespace cli
