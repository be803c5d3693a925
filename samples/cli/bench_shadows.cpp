// claque bench SCENE --shadows A,B ...: what shadows on the ground cost, side by side in one run, and that they cause
// no posing and no skinning.
#include <cstdio>
#include <memory>

#include "samples/cli/bench.h"
#include "samples/cli/progress.h"
#include "samples/cli/stopwatch.h"

namespace cli
{
namespace
{

// Of all threads, GL's too: other load on the machine affects it less than the time of the wall.
Stopwatch processor_watch() { return Stopwatch(Stopwatch::Clock::processor); }

struct ShadowsRival {
    std::string name;
    std::unique_ptr<scenes::SceneRenderer> scene_renderer;
    Times update, shadows, draw;
    clq_shadow_stats drawn = clq_shadow_stats_init();
    uint64_t skinned = 0;  // by updates
};

using Part = scenes::SceneRenderer::Part;

void frame(ShadowsRival &rival, double time_s, bool counts)
{
    rival.scene_renderer->make_current();
    const Stopwatch updating = processor_watch();
    rival.scene_renderer->update(time_s);
    const double update_ms = updating.ms();
    double shadow_ms = 0, draw_ms = 0;
    rival.scene_renderer->draw_apart([&](Part part, auto draw) {
        const Stopwatch watch = processor_watch();
        draw();
        if (part == Part::shadows) shadow_ms = watch.ms();
        if (part == Part::crowd) draw_ms = watch.ms();
    });
    rival.drawn = rival.scene_renderer->darkened();
    if (!counts) return;
    rival.update.ms.push_back(update_ms);
    rival.shadows.ms.push_back(shadow_ms);
    rival.draw.ms.push_back(draw_ms);
    rival.skinned += rival.scene_renderer->crowd_stats().skinned + rival.scene_renderer->crowd_stats().on_demand;
}

Json about(const ShadowsRival &rival, uint32_t count)
{
    const auto both = [](const Times &times) -> Json {
        return {{"minimum", times.minimum()}, {"median", times.median()}};
    };
    const clq_view_stats seen = rival.scene_renderer->view_stats();
    Json run = {{"count", count}, {"shadows", rival.name}};
    run["visible"] = seen.visible - seen.shadow_only;
    run["shadow_only"] = seen.shadow_only;
    run["update_ms"] = both(rival.update);
    run["shadow_ms"] = both(rival.shadows);
    run["draw_ms"] = both(rival.draw);
    run["skinned"] = rival.skinned;
    run["drawn"] = shadow_counters(rival.drawn);
    run["microseconds_each"] =
        rival.drawn.individuals > 0 ? 1000 * rival.shadows.median() / rival.drawn.individuals : 0.0;
    run["draw_microseconds_each"] = 1000 * rival.draw.median() / std::max(1u, seen.visible - seen.shadow_only);
    return run;
}

}  // namespace

Json bench_shadows(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.setup));
    LoadedCharacter loaded;
    if (!a.setup.file.empty()) {
        const scenes::Lod levels = a.lods.front() == "on" ? scenes::Lod::on : scenes::Lod::off;
        loaded = load_character(library, a.setup.file, a.setup.of_file, {}, levels);
    }
    Json report = {{"claque", version()}, {"threads", thread_count(a.setup)}, {"frames", a.frames}};
    report["time"] = "processor time of all threads";
    report["size_px"] = {a.setup.width, a.setup.height};
    report["runs"] = Json::array();
    for (const uint32_t count : a.counts) {
        std::vector<ShadowsRival> rivals(a.shadows.size());
        for (size_t k = 0; k < rivals.size(); ++k) {
            SceneArguments arguments = a.setup;
            arguments.count = count;
            arguments.lod = a.lods.front();
            arguments.shadows = rivals[k].name = a.shadows[k];
            const scenes::SceneOptions options = scene_options(arguments, loaded);
            report["scene"] = options.scene;
            rivals[k].scene_renderer = std::make_unique<scenes::SceneRenderer>(library, options);
        }
        const double begin_s = rivals.front().scene_renderer->scene().busiest_s();
        for (int f = 0; f <= a.frames; ++f) {
            for (size_t k = 0; k < rivals.size(); ++k)
                frame(rivals[(k + static_cast<size_t>(f)) % rivals.size()], begin_s + f / 25.0, f > 0);
            progress.step(static_cast<size_t>(f), static_cast<size_t>(a.frames));
        }
        const uint32_t people = count > 0 ? count : rivals.front().scene_renderer->crowd_stats().actor_count;
        for (const ShadowsRival &rival : rivals) report["runs"].push_back(about(rival, people));
    }
    return report;
}

void print_shadows(const Json &report)
{
    std::printf("%s, %d threads, %d frames; milliseconds of processor time of all threads, medians\n",
                report["scene"].get<std::string>().c_str(), report["threads"].get<int>(), report["frames"].get<int>());
    std::printf("%6s  %-13s %7s %7s %8s %8s %9s  %9s %9s  %7s %8s %9s\n", "people", "shadows", "visible", "outside",
                "update", "shadows", "draw", "us each", "of draw", "skinned", "draws", "triangles");
    for (const Json &run : report["runs"]) {
        const double each = run["microseconds_each"].get<double>();
        std::printf("%6u  %-13s %7u %7u %8.3f %8.3f %9.3f  %9.3f %9.3f  %7u %8u %9u\n", run["count"].get<unsigned>(),
                    run["shadows"].get<std::string>().c_str(), run["visible"].get<unsigned>(),
                    run["shadow_only"].get<unsigned>(), run["update_ms"]["median"].get<double>(),
                    run["shadow_ms"]["median"].get<double>(), run["draw_ms"]["median"].get<double>(), each,
                    each / run["draw_microseconds_each"].get<double>(), run["skinned"].get<unsigned>(),
                    run["drawn"]["draws"].get<unsigned>(), run["drawn"]["triangles"].get<unsigned>());
    }
    std::printf(
        "outside: individuals of which only the shadow is visible; us each: microseconds a shadow; of draw: a shadow's "
        "time as a share of a person's draw;\nskinned: by all updates\n");
}

}  // namespace cli
