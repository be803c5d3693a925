// claque bench of scenes of actors (S0 7.2): the cost of an update in both cull modes, side by side in one run, with
// the number of tests in each phase and calls of each mechanism; the picture is measured apart. Also measures how the
// cost grows with the number of actors out of view.
#include <cstdio>
#include <memory>

#include "samples/cli/bench.h"
#include "samples/cli/progress.h"
#include "samples/cli/timed_parts.h"

namespace cli
{
namespace
{

struct ActorsRival {
    std::string cull, cache;
    std::unique_ptr<scenes::SceneRenderer> scene_renderer;
    Times update, draw, whole;
    clq_draw_stats drawn = clq_draw_stats_init();
    std::string hash;
};

double share(uint64_t part, uint64_t whole)
{
    return whole ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

Json result_of(const ActorsRival &rival, uint32_t count)
{
    const clq_crowd_stats stats = rival.scene_renderer->crowd_stats();
    const clq_view_stats seen = rival.scene_renderer->view_stats();
    return {{"count", count},
            {"cull", rival.cull},
            {"cache", rival.cache},
            {"update_ms", {{"minimum", rival.update.minimum()}, {"median", rival.update.median()}}},
            {"draw_ms", {{"minimum", rival.draw.minimum()}, {"median", rival.draw.median()}}},
            {"frame_ms", {{"minimum", rival.whole.minimum()}, {"median", rival.whole.median()}}},
            {"draws", rival.drawn.draws},
            {"triangles_seen", seen.triangles},
            {"parts", seen.parts},
            {"parts_left_out", seen.parts_left_out},
            {"fCoh", share(stats.matrices_built, stats.matrices_needed)},
            {"fTrack", share(stats.products_tracked, stats.products)},
            {"counters", counters(stats)},
            {"picture_hash", rival.hash}};
}

// The modes take turns frame by frame, so that other load on the machine affects both alike.
void run(std::vector<ActorsRival> &rivals, const BenchArguments &a)
{
    for (int frame = 0; frame <= a.frames; ++frame)
        for (ActorsRival &rival : rivals) {
            rival.scene_renderer->make_current();
            const Stopwatch updating;
            rival.scene_renderer->update(2 + frame / 25.0);
            const double update_ms = updating.ms();
            // Pictures are expensive and alike: draw only the first and the last of a run.
            const bool draws = frame <= 1 || frame == a.frames;
            double draw_ms = 0;
            if (draws) {
                draw_ms = timed_crowd(*rival.scene_renderer);
                rival.drawn = rival.scene_renderer->drawn();
            }
            if (frame == 0) continue;
            rival.update.ms.push_back(update_ms);
            if (draws) rival.draw.ms.push_back(draw_ms);
            if (frame == a.frames) rival.hash = hex(scenes::hash_of(rival.scene_renderer->read()));
        }
    // As a host draws them: update, scenery, people, and one wait.
    for (int frame = 1; frame <= a.frames; ++frame)
        for (ActorsRival &rival : rivals) {
            rival.scene_renderer->make_current();
            const Stopwatch whole;
            rival.scene_renderer->frame(2 + (a.frames + frame) / 25.0);
            rival.whole.ms.push_back(whole.ms());
        }
}

}  // namespace

Json bench_actors(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.setup));
    Json report = {{"claque", version()}, {"kind", "actors"}};
    report["runs"] = Json::array();
    for (const uint32_t count : a.counts) {
        std::vector<ActorsRival> rivals;
        // Actor mode runs with and without caches, to show which part of the gain comes from culling.
        std::vector<std::pair<std::string, std::string>> modes;
        for (const std::string &cull : a.culls) {
            if (cull == "actor") modes.push_back({cull, "full"});
            modes.push_back({cull, "none"});
        }
        for (const auto &[cull, cache] : modes) {
            SceneArguments scene_arguments = a.setup;
            scene_arguments.count = count;
            scene_arguments.cull = cull;
            scene_arguments.cache = cache;
            const scenes::SceneOptions options = scene_options(scene_arguments, LoadedCharacter());
            rivals.push_back(
                {cull, cache, std::make_unique<scenes::SceneRenderer>(library, options), {}, {}, {}, {}, {}});
            report["scene"] = options.scene;
            report["size_px"] = {options.width, options.height};
        }
        run(rivals, a);
        std::string hash;
        for (const ActorsRival &rival : rivals) {
            expect_same_picture(hash, rival.hash, std::to_string(count) + " actors culled in mode " + rival.cull);
            report["runs"].push_back(result_of(rival, count));
        }
        if (rivals.back().cull == "traditional")
            for (const ActorsRival &rival : rivals) {
                if (rival.cull == "traditional") continue;
                const Times &slow = rivals.back().update;
                report["ratios"].push_back({{"count", count},
                                            {"cache", rival.cache},
                                            {"traditional_to_actor", slow.median() / rival.update.median()},
                                            {"by_minimum", slow.minimum() / rival.update.minimum()}});
            }
        report["context"] = rivals[0].scene_renderer->context_name();
        progress.step(report["runs"].size(), a.counts.size() * modes.size());
    }
    report["threads"] = thread_count(a.setup);
    report["frames"] = a.frames;
    return report;
}

void print_actors(const Json &report)
{
    std::printf("%s, %d x %d, %d threads, %s, %d frames\n", report["scene"].get<std::string>().c_str(),
                report["size_px"][0].get<int>(), report["size_px"][1].get<int>(), report["threads"].get<int>(),
                report["context"].get<std::string>().c_str(), report["frames"].get<int>());
    std::printf("%7s  %-11s  %-5s  %9s %9s  %9s %9s  %9s %9s  %7s %7s %7s %7s  %8s %6s %6s\n", "actors", "cull",
                "cache", "update ms", "median", "draw ms", "median", "frame ms", "median", "tested", "phase 1",
                "phase 2", "drawn", "calls", "fCoh", "fTrack");
    for (const Json &r : report["runs"]) {
        const Json &c = r["counters"];
        uint64_t calls = 0;
        for (const Json &of_kind : c["behaviour_calls"]) calls += of_kind.get<uint64_t>();
        std::printf(
            "%7u  %-11s  %-5s  %9.3f %9.3f  %9.2f %9.2f  %9.2f %9.2f  %7u %7u %7u %7u  %8llu %6.3f %6.3f\n",
            r["count"].get<unsigned>(), r["cull"].get<std::string>().c_str(), r["cache"].get<std::string>().c_str(),
            r["update_ms"]["minimum"].get<double>(), r["update_ms"]["median"].get<double>(),
            r["draw_ms"]["minimum"].get<double>(), r["draw_ms"]["median"].get<double>(),
            r["frame_ms"]["minimum"].get<double>(), r["frame_ms"]["median"].get<double>(), c["tested"].get<unsigned>(),
            c["passed_refpoint"].get<unsigned>(), c["passed_sklsroot"].get<unsigned>(), c["visible"].get<unsigned>(),
            static_cast<unsigned long long>(calls), r["fCoh"].get<double>(), r["fTrack"].get<double>());
    }
    if (!report.contains("ratios")) return;
    for (const Json &r : report["ratios"])
        std::printf(
            "%u actors, cache %s: traditional takes %.1f times the update of actor mode by the median, %.1f by the "
            "minimum\n",
            r["count"].get<unsigned>(), r["cache"].get<std::string>().c_str(), r["traditional_to_actor"].get<double>(),
            r["by_minimum"].get<double>());
}

}  // namespace cli
