// claque bench flicker: how much a picture flickers while the camera moves slowly past a crowd that stands still. The
// error of a frame is its difference from the mean of sixteen pictures whose pixels are moved by parts of a pixel. An
// error that stays is a coarse picture; one that changes from frame to frame is seen as flicker, so its change is
// measured.
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "samples/cli/bench.h"
#include "samples/cli/progress.h"

namespace cli
{
namespace
{

constexpr uint32_t samples = 16;
constexpr double slow_s = 1 / 100.0;  // of the path's time between two frames: a quarter of its speed at 25 a second

std::vector<int> error_of(scenes::SceneRenderer &scene_renderer, double time_s)
{
    const std::vector<uint8_t> frame = scene_renderer.picture(time_s);
    const std::vector<uint8_t> &reference = scene_renderer.picture(time_s, samples);
    std::vector<int> error(frame.size());
    for (size_t i = 0; i < frame.size(); ++i) error[i] = int(frame[i]) - int(reference[i]);
    return error;
}

// Means over pixels and channels, of 255: of the error, and of its change from frame to frame.
Json measured(scenes::SceneRenderer &scene_renderer, const scenes::PathSection &section, int frames)
{
    const double middle_s = (section.start_s + section.end_s) / 2;
    scene_renderer.hold_crowd(middle_s);
    double errors = 0, changes = 0;
    std::vector<int> before;
    for (int i = 0; i <= frames; ++i) {
        const std::vector<int> now = error_of(scene_renderer, middle_s + (i - frames * 0.5) * slow_s);
        for (size_t k = 0; k < before.size(); ++k) {
            errors += std::abs(now[k]);
            changes += std::abs(now[k] - before[k]);
        }
        before = now;
    }
    const double all = static_cast<double>(before.size()) * frames;
    return {{"error", errors / all}, {"flicker", changes / all}};
}

}  // namespace

bool is_of_flicker(const BenchArguments &a) { return a.subject == "flicker"; }

Json bench_flicker(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.setup));
    Json report = {{"claque", version()}, {"kind", "flicker"}, {"frames", a.frames}};
    report["runs"] = Json::array();
    for (const std::string &lod : a.lods) {
        SceneArguments arguments = a.setup;
        arguments.scene = "odeon", arguments.camera = "path", arguments.lod = lod;
        scenes::SceneRenderer scene_renderer(library, scene_options(arguments, LoadedCharacter()));
        report["size_px"] = {arguments.width, arguments.height};
        report["context"] = scene_renderer.context_name();
        const std::vector<scenes::PathSection> &sections = scene_renderer.path()->sections();
        for (const scenes::PathSection &section : sections) {
            Json run = {{"section", section.name}, {"levels", lod == "on"}};
            run.update(measured(scene_renderer, section, a.frames));
            report["runs"].push_back(std::move(run));
            progress.step(report["runs"].size(), a.lods.size() * sections.size());
        }
    }
    return report;
}

void print_flicker(const Json &report)
{
    std::printf("odeon, %d x %d, %s, %d frames a section\n%-16s %-7s %8s %8s\n", report["size_px"][0].get<int>(),
                report["size_px"][1].get<int>(), report["context"].get<std::string>().c_str(),
                report["frames"].get<int>(), "section", "levels", "error", "flicker");
    for (const Json &run : report["runs"])
        std::printf("%-16s %-7s %8.3f %8.3f\n", run["section"].get<std::string>().c_str(),
                    run["levels"].get<bool>() ? "on" : "off", run["error"].get<double>(), run["flicker"].get<double>());
    std::printf("Means over pixels and channels, of 255: the error of a frame against 16 samples, and its change.\n");
}

}  // namespace cli
