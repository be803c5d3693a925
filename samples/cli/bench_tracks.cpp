// claque bench tracks: what walking on tracks costs over walking in place, for the same people in the same street.
#include <cstdio>

#include "samples/cli/bench.h"
#include "samples/cli/progress.h"
#include "samples/cli/timed_parts.h"
#include "samples/scenes/walkers/street.h"

namespace cli
{

bool is_of_tracks(const BenchArguments &a) { return a.subject == "tracks"; }

namespace
{

struct Street {
    std::unique_ptr<scenes::SceneRenderer> renderer;
    Times update, draw;

    void frame(double time_s, bool measured)
    {
        renderer->make_current();
        const Stopwatch updating;
        renderer->update(time_s);
        const double update_ms = updating.ms();
        const double draw_ms = timed_crowd(*renderer);
        if (!measured) return;
        update.ms.push_back(update_ms), draw.ms.push_back(draw_ms);
    }
    Json report(const char *kind) const
    {
        const clq_crowd_stats stats = renderer->crowd_stats();
        return {{"kind", kind},
                {"count", stats.actor_count},
                {"visible", stats.visible},
                {"animated", stats.animated},
                {"update_ms", {{"minimum", update.minimum()}, {"median", update.median()}}},
                {"draw_ms", {{"minimum", draw.minimum()}, {"median", draw.median()}}}};
    }
};

Street street_of(const BenchArguments &a, scenes::Library &library, uint32_t count, bool on_tracks)
{
    scenes::SceneOptions options = scene_options(a.setup, LoadedCharacter());
    options.scene = "street";
    options.crowd_options.count = count;
    options.crowd_options.lod = scenes::Lod::on;
    options.shot = scenes::Shot::overview;
    options.make = [on_tracks](scenes::Library &own, const scenes::CrowdOptions &crowd_options) {
        return scenes::walkers::make_street(own, crowd_options, on_tracks);
    };
    Street street;
    street.renderer = std::make_unique<scenes::SceneRenderer>(library, options);
    return street;
}

double ratio(const Json &on_tracks, const Json &in_place, const char *value)
{
    const auto sum = [&](const Json &run) {
        return run["update_ms"][value].get<double>() + run["draw_ms"][value].get<double>();
    };
    return sum(on_tracks) / sum(in_place);
}

}  // namespace

Json bench_tracks(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.setup));
    Json report = {{"claque", version()},
                   {"runs", Json::array()},
                   {"size_px", {a.setup.width, a.setup.height}},
                   {"threads", thread_count(a.setup)},
                   {"frames", a.frames}};
    size_t done = 0;
    for (const uint32_t count : a.counts) {
        Street in_place = street_of(a, library, count, false), walking = street_of(a, library, count, true);
        report["context"] = walking.renderer->context_name();
        // One after the other, frame by frame, so that the machine's mood is the same for both.
        for (int frame = -3; frame < a.frames; ++frame)
            for (Street *street : {&in_place, &walking}) street->frame(30 + frame / 25.0, frame >= 0);
        Json placed = in_place.report("in place"), moved = walking.report("on tracks");
        moved["ratio"] = {{"minimum", ratio(moved, placed, "minimum")}, {"median", ratio(moved, placed, "median")}};
        report["runs"].push_back(std::move(placed)), report["runs"].push_back(std::move(moved));
        progress.step(++done, a.counts.size());
    }
    return report;
}

void print_tracks(const Json &report)
{
    std::printf("%-10s %7s %8s %9s  %17s  %17s  %s\n", "citizens", "count", "in view", "posed", "update ms min/med",
                "draw ms min/med", "ratio of update and draw min/med");
    for (const Json &r : report["runs"]) {
        std::printf("%-10s %7u %8u %9u  %8.2f %8.2f  %8.2f %8.2f", r["kind"].get<std::string>().c_str(),
                    r["count"].get<unsigned>(), r["visible"].get<unsigned>(), r["animated"].get<unsigned>(),
                    r["update_ms"]["minimum"].get<double>(), r["update_ms"]["median"].get<double>(),
                    r["draw_ms"]["minimum"].get<double>(), r["draw_ms"]["median"].get<double>());
        if (r.contains("ratio"))
            std::printf("  %.3f %.3f", r["ratio"]["minimum"].get<double>(), r["ratio"]["median"].get<double>());
        std::printf("\n");
    }
}

}  // namespace cli
