// claque bench of a scene without a camera path: what a frame costs, by number of people, by cache and by variety.
#include "samples/cli/bench.h"
#include "samples/cli/interrupt.h"
#include "samples/cli/progress.h"
#include "samples/cli/stopwatch.h"

#include <algorithm>
#include <cstdio>
#include <map>

namespace cli
{
namespace
{

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

}  // namespace

Json bench_by_count(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.stage));
    LoadedCharacter loaded;
    if (!a.stage.file.empty()) loaded = load_character(library, a.stage.file, a.stage.hidden);
    Json report = {{"claque", version()}};
    report["runs"] = Json::array();
    const size_t all = a.counts.size() * a.caches.size() * a.varieties.size();
    for (uint32_t count : a.counts) {
        std::map<std::string, std::string> hashes;  // by what caches show
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
                expect_same_picture(hashes[picture_of(cache)], result["picture_hash"].get<std::string>(),
                                    std::to_string(count) + " people with cache " + cache + " and variety " + variety);
                report["runs"].push_back(std::move(result));
                progress.step(report["runs"].size(), all);
            }
        }
    }
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
    std::printf("%6s  %-*s  %-8s  %10s %10s  %10s %10s  %8s %8s  %s\n", "people", cache_wide, "cache", "variety",
                "update ms", "median", "draw ms", "median", "animated", "draws", "picture");
    for (const Json &r : report["runs"])
        std::printf("%6u  %-*s  %-8s  %10.2f %10.2f  %10.2f %10.2f  %8u %8u  %s\n", r["count"].get<unsigned>(),
                    cache_wide, r["cache"].get<std::string>().c_str(), r["variety"].get<std::string>().c_str(),
                    r["update_ms"]["minimum"].get<double>(), r["update_ms"]["median"].get<double>(),
                    r["draw_ms"]["minimum"].get<double>(), r["draw_ms"]["median"].get<double>(),
                    r["counters"]["animated"].get<unsigned>(), r["draws"].get<unsigned>(),
                    r["picture_hash"].get<std::string>().c_str());
}

}  // namespace cli
