// claque bench of a scene without a camera path: what a frame costs, by number of people, by cache and by draw
// strategy.
#include <algorithm>
#include <cstdio>
#include <map>

#include "samples/cli/bench.h"
#include "samples/cli/progress.h"
#include "samples/cli/timed_parts.h"

namespace cli
{
namespace
{

// Draws one time of the crowd repeatedly: with a GL that does nothing, which leaves claque's own work; with a scissor
// box that clips all pixels; and completely.
Json draw_parts(scenes::SceneRenderer &scene_renderer, int frames)
{
    using Part = scenes::SceneRenderer::DrawPart;
    Times library, vertices, all;
    const auto timed = [&](Times &times, Part part) {
        const Stopwatch watch;
        scene_renderer.draw_crowd_up_to(part);
        times.ms.push_back(watch.ms());
    };
    for (int frame = 0; frame < frames; ++frame) {
        timed(library, Part::claque), timed(vertices, Part::and_vertices), timed(all, Part::all);
    }
    const auto of = [](double minimum, double median) -> Json { return {{"minimum", minimum}, {"median", median}}; };
    return {{"claque", of(library.minimum(), library.median())},
            {"gl_vertices", of(vertices.minimum() - library.minimum(), vertices.median() - library.median())},
            {"gl_pixels", of(all.minimum() - vertices.minimum(), all.median() - vertices.median())}};
}

// Frames 1 to n of a warm crowd, with a wait after each part; frame 0 fills the caches and is not counted. Then as
// many complete frames as a host draws them: update, environment, shadows, people, and one wait.
Json run(scenes::SceneRenderer &scene_renderer, const BenchArguments &a)
{
    Times update, draw;
    const double begin_s = scene_renderer.scene().busiest_s();
    clq_draw_stats drawn = clq_draw_stats_init();
    scenes::check(clq_crowd_reset_bands(scene_renderer.scene().crowd()));
    for (int frame = 0; frame <= a.frames; ++frame) {
        const Stopwatch updating;
        scene_renderer.update(begin_s + frame / 25.0);
        const double update_ms = updating.ms();
        const double draw_ms = timed_crowd(scene_renderer);
        drawn = scene_renderer.drawn();
        if (frame == 0) continue;
        update.ms.push_back(update_ms);
        draw.ms.push_back(draw_ms);
    }
    const clq_crowd_stats stats = scene_renderer.crowd_stats();
    const Json parts = draw_parts(scene_renderer, a.frames);
    const std::string picture = hex(scenes::hash_of(scene_renderer.read()));
    Times whole;
    for (int frame = 1; frame <= a.frames; ++frame) {
        const Stopwatch watch;
        scene_renderer.frame(begin_s + (a.frames + frame) / 25.0);
        whole.ms.push_back(watch.ms());
    }
    return {{"update_ms", {{"minimum", update.minimum()}, {"median", update.median()}}},
            {"draw_ms", {{"minimum", draw.minimum()}, {"median", draw.median()}}},
            {"draw_parts_ms", parts},
            {"frame_ms", {{"minimum", whole.minimum()}, {"median", whole.median()}}},
            {"draws", drawn.draws},
            {"triangles_sent", drawn.triangles},
            {"vertices_sent", drawn.vertices},
            {"counters", counters(stats)},
            {"bands", rates(stats)},
            {"picture_hash", picture}};
}

// How the cost with the first cache and strategy grows with the crowd, for claque plot.
void chart(Json &report)
{
    constexpr double least_ms = 0.001;  // differences of times may be zero, which has no logarithm
    const auto line = [&](const char *name, const auto &median) {
        Json points = Json::array();
        const Json &first = report["runs"][0];
        for (const Json &r : report["runs"])
            if (r["cache"] == first["cache"] && r["strategy"] == first["strategy"])
                points.push_back({r["count"], std::max(median(r)["median"].template get<double>(), least_ms)});
        report["series"].push_back({{"name", name}, {"points", std::move(points)}});
    };
    report["kind"] = "lines";
    report["title"] = "What a frame of " + report["scene"].get<std::string>() + " takes";
    report["x"] = {{"title", "people in view"}, {"scale", "log"}};
    report["y"] = {{"title", "milliseconds, median"}, {"scale", "log"}};
    report["series"] = Json::array();
    line("whole frame", [](const Json &r) { return r["frame_ms"]; });
    line("draw: GL, pixels", [](const Json &r) { return r["draw_parts_ms"]["gl_pixels"]; });
    line("draw: GL, vertices", [](const Json &r) { return r["draw_parts_ms"]["gl_vertices"]; });
    line("draw: claque", [](const Json &r) { return r["draw_parts_ms"]["claque"]; });
    line("update", [](const Json &r) { return r["update_ms"]; });
    report["note"] = report["context"].get<std::string>() + ", " + std::to_string(report["threads"].get<int>()) +
                     " threads, medians of " + std::to_string(report["frames"].get<int>()) + " frames";
}

}  // namespace

Json bench_by_count(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.setup));
    LoadedCharacter loaded;
    if (!a.setup.file.empty()) loaded = load_character(library, a.setup.file, a.setup.of_file);
    Json report = {{"claque", version()}};
    report["runs"] = Json::array();
    const size_t all = a.counts.size() * a.caches.size() * a.strategies.size();
    for (uint32_t count : a.counts) {
        std::map<std::string, std::string> hashes;  // by what the caches show
        for (const std::string &cache : a.caches) {
            SceneArguments scene_arguments = a.setup;
            scene_arguments.count = count;
            scene_arguments.cache = cache;
            scenes::SceneOptions options = scene_options(scene_arguments, loaded);
            options.tells_parts = true;
            scenes::SceneRenderer scene_renderer(library, options);
            report["scene"] = options.scene;
            report["size_px"] = {options.width, options.height};
            report["threads"] = thread_count(a.setup);
            report["context"] = scene_renderer.context_name();
            report["frames"] = a.frames;
            const uint32_t people = count > 0 ? count : scene_renderer.crowd_stats().actor_count;
            for (const std::string &strategy : a.strategies) {
                scene_renderer.use_strategy(strategy_named(strategy));
                Json result = {{"count", people}, {"cache", cache}, {"strategy", strategy}};
                result.update(run(scene_renderer, a));
                expect_same_picture(
                    hashes[picture_of(cache)], result["picture_hash"].get<std::string>(),
                    std::to_string(people) + " people with cache " + cache + " and strategy " + strategy);
                report["runs"].push_back(std::move(result));
                progress.step(report["runs"].size(), all);
            }
        }
    }
    if (a.counts.size() > 1) chart(report);
    return report;
}

void print_counts(const Json &report)
{
    std::printf("%s, %d x %d, %d threads, %s, %d frames\n", report["scene"].get<std::string>().c_str(),
                report["size_px"][0].get<int>(), report["size_px"][1].get<int>(), report["threads"].get<int>(),
                report["context"].get<std::string>().c_str(), report["frames"].get<int>());
    size_t wide = 9;
    for (const Json &r : report["runs"]) wide = std::max(wide, r["cache"].get<std::string>().size());
    const int cache_wide = static_cast<int>(wide);
    std::printf("%6s  %-*s  %-8s  %8s %8s  %8s %8s  %8s %8s %8s  %8s %8s  %8s %6s  %s\n", "people", cache_wide, "cache",
                "strategy", "update", "median", "draw", "median", "claque", "vertices", "pixels", "frame", "median",
                "animated", "draws", "picture");
    const auto ms = [](const Json &times, const char *which) { return times[which].get<double>(); };
    for (const Json &r : report["runs"]) {
        const Json &parts = r["draw_parts_ms"];
        std::printf("%6u  %-*s  %-8s  %8.2f %8.2f  %8.2f %8.2f  %8.2f %8.2f %8.2f  %8.2f %8.2f  %8u %6u  %s\n",
                    r["count"].get<unsigned>(), cache_wide, r["cache"].get<std::string>().c_str(),
                    r["strategy"].get<std::string>().c_str(), ms(r["update_ms"], "minimum"),
                    ms(r["update_ms"], "median"), ms(r["draw_ms"], "minimum"), ms(r["draw_ms"], "median"),
                    ms(parts["claque"], "minimum"), ms(parts["gl_vertices"], "minimum"),
                    ms(parts["gl_pixels"], "minimum"), ms(r["frame_ms"], "minimum"), ms(r["frame_ms"], "median"),
                    r["counters"]["animated"].get<unsigned>(), r["draws"].get<unsigned>(),
                    r["picture_hash"].get<std::string>().c_str());
    }
    std::printf(
        "milliseconds, minimum and median; claque, vertices and pixels are parts of drawing one time, minima\n");
}

}  // namespace cli
