// Draws one picture of a scene, or a sequence.
#include <cmath>
#include <optional>
#include <unistd.h>
#include <utility>

#include "samples/cli/files.h"
#include "samples/cli/film_about.h"
#include "samples/cli/filtering.h"
#include "samples/cli/manifest.h"
#include "samples/cli/measured_rates.h"
#include "samples/cli/png.h"
#include "samples/cli/progress.h"
#include "samples/cli/render_work.h"
#include "samples/cli/stopwatch.h"

namespace cli
{
namespace
{

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
    std::vector<int> numbers;
    for (size_t i = 0; i < a.list.size(); i += static_cast<size_t>(a.range.stride)) numbers.push_back(a.list[i]);
    if (a.list.empty()) numbers = frames_of(range);
    for (int number : chunk_of(numbers, a.chunk, a.chunk_count))
        frames.push_back({number, number / a.fps, frame_path(a.out, number)});
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

std::string camera_of(const RenderArguments &a, const scenes::SceneOptions &options)
{
    if (options.shot == scenes::Shot::path) return "path";
    if (options.shot == scenes::Shot::close) return "close";
    if (!followed_by(a.setup.camera).empty() || !options.viewpoint.empty()) return a.setup.camera;
    const bool follows = a.setup.described && a.setup.camera.empty() && !a.setup.described->follow.empty();
    return follows ? "follow:" + a.setup.described->follow : "overview";
}

Json about(const RenderArguments &a, const scenes::SceneOptions &options)
{
    Json report;
    report["claque"] = version();
    report["scene"] = options.scene;
    if (!a.setup.file.empty()) report["file"] = a.setup.file;
    report["seed"] = options.crowd_options.seed;
    report["size_px"] = {options.width, options.height};
    report["camera"] = camera_of(a, options);
    if (!a.setup.path.empty()) report["path"] = a.setup.path;
    if (!a.setup.scenario.empty()) report["scenario"] = a.setup.scenario;
    if (!a.colours.file.empty()) report["colours"] = a.colours.file;
    report["strategy"] = a.setup.strategy;
    report["cache"] = a.setup.cache;
    report["threads"] = thread_count(a.setup);
    return report;
}

}  // namespace

void render(const RenderArguments &a)
{
    Progress progress("claque");
    expect_writable(frame_path(a.out, 0));
    if (!a.json.empty()) expect_writable(a.json);

    if (!a.manifest.empty()) expect_writable(a.manifest);

    scenes::Library library(thread_count(a.setup));
    LoadedCharacter loaded;
    scenes::SceneOptions options = scene_options(a.setup, loaded);
    std::optional<scenes::SceneRenderer> scene_renderer;
    std::optional<Manifest> manifest;
    Json report = about(a, options);
    const auto prepare = [&] {
        progress.phase("preparing");
        if (!a.setup.file.empty())
            loaded = load_character(library, a.setup.file, a.setup.hidden, a.clips, levels_of_file(a.setup));
        options = scene_options(a.setup, loaded);
        scene_renderer.emplace(library, options);
        report["count"] = scene_renderer->crowd_stats().actor_count;
        report["context"] = scene_renderer->context_name();
    };
    std::vector<Frame> frames = planned(a, options);
    if (!a.manifest.empty()) {
        std::vector<int> numbers;
        for (const Frame &frame : frames) numbers.push_back(frame.number);
        prepare();
        manifest.emplace(a.manifest, film_about(a, options, scene_renderer->context_name()), numbers);
    }
    const auto is_done = [&](const Frame &frame) {
        return manifest ? !a.again && manifest->has(frame.number, frame.path) : finished(a, options, frame);
    };
    report["skipped"] = Json::array();
    for (const Frame &frame : std::exchange(frames, {})) {
        if (is_done(frame)) report["skipped"].push_back(frame.number);
        else frames.push_back(frame);
    }

    SceneColours wardrobe(library, a.colours, options.crowd_options.seed);
    report["frames"] = Json::array();
    for (size_t i = 0; i < frames.size(); ++i) {
        if (!scene_renderer) prepare();
        wardrobe.apply_to(*scene_renderer);
        report["frames"].push_back(draw(*scene_renderer, options, frames[i], a.samples));
        if (manifest) manifest->add(frames[i].number, frames[i].path);
        progress.step(i + 1, frames.size());
    }
    a.drawn();
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

}  // namespace cli
