// claque bench SCENE --processes 1,2,4: a picture in as many tiles, side by side in one run, and a model of more
// processes than this machine has cores: each tile costs the scenery, what an update does for all people and the people
// on its borders, and its share of the rest.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "samples/cli/bench.h"
#include "samples/cli/frame_crew.h"
#include "samples/cli/machine.h"
#include "samples/cli/progress.h"
#include "samples/cli/stopwatch.h"

namespace cli
{
namespace
{

constexpr int warm_frames = 4, most_modelled = 64;

struct ProcessRival {
    RenderArguments arguments;
    std::unique_ptr<FrameCrew> crew;
    Times wall, slowest, mean;  // of a picture; processor time of its slowest tile, and of one in the mean
    double vertices = 0, individuals = 0;
};

std::unique_ptr<ProcessRival> rival_of(const BenchArguments &a, int processes)
{
    auto rival = std::make_unique<ProcessRival>();
    rival->arguments.setup = a.setup;
    rival->arguments.setup.cache = a.caches.size() == 1 ? a.caches[0] : "full";
    rival->arguments.setup.strategy = a.strategies.size() == 1 ? a.strategies[0] : "fused";
    rival->arguments.setup.lod = a.lods[0];
    if (!a.setup.described) rival->arguments.setup.count = a.counts.back();
    rival->arguments.processes = processes;
    rival->arguments.divide = "tiles";
    rival->crew = std::make_unique<FrameCrew>(rival->arguments);
    return rival;
}

void frame(ProcessRival &rival, double time_s, bool counts, std::string &picture)
{
    rival.crew->draw({{-1, time_s, "-"}}, [&](size_t, const Json &report, const unsigned char *, size_t) {
        expect_same_picture(picture, report["picture_hash"],
                            "one time by " + std::to_string(rival.arguments.processes) + " processes");
        if (!counts) return;
        double most = 0, sum = 0;
        for (const Json &tile : report["tiles"]) {
            const double ms = tile["cpu_ms"];
            most = std::max(most, ms), sum += ms;
            rival.vertices += tile["drawn"]["vertices_sent"].get<double>();
            rival.individuals += tile["drawn"]["individuals"].get<double>();
        }
        rival.wall.ms.push_back(report["wall_ms"]);
        rival.slowest.ms.push_back(most);
        rival.mean.ms.push_back(sum / static_cast<double>(report["tiles"].size()));
    });
}

Json spread_of(const Times &times) { return {{"minimum", times.minimum()}, {"median", times.median()}}; }

// From the first two numbers of processes, the first of which is 1. People on borders are in two tiles, and a tile has
// as many borders however many tiles there are, so they count as a part of every tile.
struct ProcessModel {
    double each_ms, divided_ms;
    double ms(double n) const { return each_ms + divided_ms / n; }
};

ProcessModel model_of(const ProcessRival &one, const ProcessRival &other)
{
    const double n = other.arguments.processes, ms = one.mean.median();
    const double divided = (ms - other.mean.median()) / (1 - 1 / n);
    return {ms - divided, divided};
}

}  // namespace

Json bench_processes(const BenchArguments &a)
{
    Progress progress("claque bench");
    std::vector<std::unique_ptr<ProcessRival>> rivals;
    for (const int processes : a.processes) rivals.push_back(rival_of(a, processes));
    progress.phase("preparing");
    Subject subject;
    for (const auto &rival : rivals) subject = rival->crew->subject();
    const double from_s = a.setup.camera == "path" ? 10 : 2;
    for (int k = -warm_frames; k < a.frames; ++k) {
        std::string picture;
        for (size_t i = 0; i < rivals.size(); ++i)
            frame(*rivals[(i + static_cast<size_t>(k + warm_frames)) % rivals.size()], from_s + k / 25.0, k >= 0,
                  picture);
        progress.step(static_cast<size_t>(k + warm_frames + 1), static_cast<size_t>(a.frames + warm_frames));
    }
    Json report = {{"claque", version()},
                   {"kind", "lines"},
                   {"title", "Frames a second of one picture in tiles"},
                   {"subtitle", scene_of(a.setup) + ", " + std::to_string(subject.count) + " individuals"},
                   {"x", {{"title", "processes, a core each"}, {"scale", "log"}}},
                   {"y", {{"title", "frames a second"}, {"scale", "log"}}},
                   {"series", Json::array()},
                   {"scene", scene_of(a.setup)},
                   {"count", subject.count},
                   {"context", subject.context},
                   {"machine", machine()},
                   {"frames", a.frames},
                   {"runs", Json::array()}};
    const bool has_model = rivals.size() > 1 && a.processes[0] == 1 && a.processes[1] > 1;
    const ProcessModel model = has_model ? model_of(*rivals[0], *rivals[1]) : ProcessModel{};
    Json measured = Json::array();
    for (const auto &rival : rivals) {
        const int n = rival->arguments.processes;
        Json run = {{"processes", n},
                    {"wall_ms", spread_of(rival->wall)},
                    {"slowest_tile_cpu_ms", spread_of(rival->slowest)},
                    {"mean_tile_cpu_ms", spread_of(rival->mean)},
                    {"individuals", rival->individuals / a.frames},
                    {"vertices", rival->vertices / a.frames}};
        if (has_model) run["modelled_tile_cpu_ms"] = model.ms(n);
        measured.push_back({n, 1000 / rival->slowest.median()});
        report["runs"].push_back(std::move(run));
    }
    report["series"].push_back({{"name", "measured: the slowest tile's processor time"}, {"points", measured}});
    if (has_model) {
        Json points = Json::array();
        for (int n = 1; n <= most_modelled; n *= 2) points.push_back({n, 1000 / model.ms(n)});
        report["series"].push_back({{"name", "model"}, {"points", points}, {"dash", "dashed"}});
        report["model"] = {{"each_ms", model.each_ms}, {"divided_ms", model.divided_ms}};
    }
    report["note"] =
        "the model assumes a core for each process, memory as fast for all, equal tiles, and tiles wider than people";
    return report;
}

void print_processes(const Json &report)
{
    std::printf("%s, %u individuals, medians (minima) of %d frames\n", report["scene"].get<std::string>().c_str(),
                report["count"].get<unsigned>(), report["frames"].get<int>());
    std::printf("%9s %18s %18s %18s %9s %11s %10s\n", "processes", "picture ms", "slowest tile, cpu", "mean tile, cpu",
                "modelled", "individuals", "vertices");
    for (const Json &run : report["runs"]) {
        const auto times = [&](const char *name) {
            char text[40];
            std::snprintf(text, sizeof text, "%.1f (%.1f)", run[name]["median"].get<double>(),
                          run[name]["minimum"].get<double>());
            return std::string(text);
        };
        std::printf("%9d %18s %18s %18s %9.1f %11.0f %10.0f\n", run["processes"].get<int>(), times("wall_ms").c_str(),
                    times("slowest_tile_cpu_ms").c_str(), times("mean_tile_cpu_ms").c_str(),
                    run.value("modelled_tile_cpu_ms", 0.0), run["individuals"].get<double>(),
                    run["vertices"].get<double>());
    }
    if (report.contains("model"))
        std::printf("a tile of N costs %.1f ms + %.1f ms / N\n", report["model"]["each_ms"].get<double>(),
                    report["model"]["divided_ms"].get<double>());
}

}  // namespace cli
