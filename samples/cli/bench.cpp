// claque bench: what a frame costs, by number of people, by cache and by variety, in one run. A picture's hash stands
// beside every time: they have to be equal for equal counts, or the times mean nothing.
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/interrupt.h"
#include "samples/cli/progress.h"
#include "samples/cli/stage_arguments.h"
#include "samples/cli/stopwatch.h"

#include <cstdio>
#include <iostream>
#include <memory>

namespace cli
{
namespace
{

struct BenchArguments {
    StageArguments stage;
    std::string subject;
    std::vector<uint32_t> counts = {100, 500, 1000};
    std::vector<std::string> varieties = {"per-zone", "binned", "fused"}, caches = {"none", "animation", "full"};
    int frames = 25;
    bool json = false;
};

// Frames 1 to n of a warm crowd; the one before them fills the caches and is not counted.
Json run(scenes::Stage &stage, const BenchArguments &a)
{
    Times update, draw;
    clq_draw_stats drawn = {};
    scenes::check(clq_crowd_reset_bands(stage.scene().crowd()));
    for (int frame = 0; frame <= a.frames; ++frame) {
        stop_if_asked();
        const Stopwatch updating;
        stage.update(frame / 25.0);
        const double update_ms = updating.ms();
        stage.draw_setting();
        stage.gl().Finish();
        const Stopwatch drawing;
        drawn = stage.draw_crowd();
        if (frame == 0) continue;
        update.ms.push_back(update_ms);
        draw.ms.push_back(drawing.ms());
    }
    const clq_crowd_stats stats = stage.crowd_stats();
    return {{"update_ms", {{"minimum", update.minimum()}, {"median", update.median()}}},
            {"draw_ms", {{"minimum", draw.minimum()}, {"median", draw.median()}}},
            {"frame_ms", {{"minimum", update.minimum() + draw.minimum()}, {"median", update.median() + draw.median()}}},
            {"draws", drawn.draws},
            {"triangles_sent", drawn.triangles},
            {"vertices_sent", drawn.vertices},
            {"counters", counters(stats)},
            {"bands", rates(stats)},
            {"picture_hash", hex(scenes::hash_of(stage.read()))}};
}

void print_table(const Json &report)
{
    std::printf("%s, %d x %d, %d threads, %s, %d frames\n", report["scene"].get<std::string>().c_str(),
                report["size_px"][0].get<int>(), report["size_px"][1].get<int>(), report["threads"].get<int>(),
                report["context"].get<std::string>().c_str(), report["frames"].get<int>());
    std::printf("%6s  %-9s  %-8s  %10s %10s  %10s %10s  %8s %8s  %s\n", "people", "cache", "variety", "update ms",
                "median", "draw ms", "median", "animated", "draws", "picture");
    for (const Json &r : report["runs"])
        std::printf("%6u  %-9s  %-8s  %10.2f %10.2f  %10.2f %10.2f  %8u %8u  %s\n", r["count"].get<unsigned>(),
                    r["cache"].get<std::string>().c_str(), r["variety"].get<std::string>().c_str(),
                    r["update_ms"]["minimum"].get<double>(), r["update_ms"]["median"].get<double>(),
                    r["draw_ms"]["minimum"].get<double>(), r["draw_ms"]["median"].get<double>(),
                    r["counters"]["animated"].get<unsigned>(), r["draws"].get<unsigned>(),
                    r["picture_hash"].get<std::string>().c_str());
}

Json measure_all(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.stage));
    LoadedCharacter loaded;
    if (!a.stage.file.empty()) loaded = load_character(library, a.stage.file, a.stage.hidden);
    Json report = {{"claque", version()}};
    report["runs"] = Json::array();
    const size_t all = a.counts.size() * a.caches.size() * a.varieties.size();
    for (uint32_t count : a.counts) {
        std::string hash;
        for (const std::string &cache : a.caches) {
            StageArguments stage_arguments = a.stage;
            stage_arguments.count = count;
            stage_arguments.cache = cache;
            const scenes::StageOptions options = stage_options(stage_arguments, loaded);
            scenes::Stage stage(library, options);
            report["scene"] = options.scene;
            report["size_px"] = {options.width, options.height};
            report["threads"] = thread_count(a.stage);
            report["context"] = stage.context_name();
            report["frames"] = a.frames;
            for (const std::string &variety : a.varieties) {
                stage.use_variety(variety_named(variety));
                Json result = {{"count", count}, {"cache", cache}, {"variety", variety}};
                result.update(run(stage, a));
                const std::string now = result["picture_hash"].get<std::string>();
                if (hash.empty()) hash = now;
                if (now != hash)
                    throw scenes::Failure("the picture of " + std::to_string(count) + " people with cache " + cache +
                                          " and variety " + variety + " differs (" + now + ", not " + hash +
                                          "), so the times mean nothing");
                report["runs"].push_back(std::move(result));
                progress.step(report["runs"].size(), all);
            }
        }
    }
    return report;
}

void bench(const BenchArguments &a)
{
    const Json report = measure_all(a);
    if (a.json) std::cout << report.dump(2) << "\n";
    else print_table(report);
}

}  // namespace

void add_bench(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<BenchArguments>();
    CLI::App *c = app.add_subcommand("bench", "Measure update and draw by number of people, cache and variety");
    c->add_option("SCENE", a->subject, "A scene's name, or a character's file")->required();
    c->add_option("--count", a->counts, "Numbers of people, with commas")
        ->delimiter(',')
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    c->add_option("--variety", a->varieties, "Which, with commas")
        ->delimiter(',')
        ->check(CLI::IsMember(variety_names()))
        ->capture_default_str();
    c->add_option("--cache", a->caches, "Which, with commas")
        ->delimiter(',')
        ->check(CLI::IsMember(cache_names()))
        ->capture_default_str();
    c->add_option("--frames", a->frames, "Measured frames a run, at 25 a second")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    add_stage_options(*c, a->stage);
    c->add_flag("--json", a->json, "As JSON instead of a table");
    c->callback([a, &chosen] {
        a->stage.file = a->subject;
        for (const scenes::SceneEntry &entry : scenes::scene_entries())
            if (a->subject == entry.name) {
                a->stage.scene = a->subject;
                a->stage.file.clear();
            }
        chosen = [a] { bench(*a); };
    });
}

}  // namespace cli
