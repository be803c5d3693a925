// claque bench flicker: how much a picture flickers while the camera moves slowly past a crowd that stands still. The
// error of a frame is its difference from the mean of sixteen pictures whose pixels are moved by parts of a pixel. An
// error that stays is a coarse picture; one that changes from frame to frame is seen as flicker, so its change is
// measured. A picture that is blurred has no flicker either, so its sharpness is measured too: the root mean square of
// the steps between neighbouring pixels, as a part of that of the sixteen pictures' mean.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "samples/cli/bench.h"
#include "samples/cli/progress.h"

namespace cli
{
namespace
{

using Pixels = std::vector<uint8_t>;

constexpr uint32_t samples = 16, first_sample = 9;  // which no manner has among its pictures
constexpr double slow_s = 1 / 100.0;  // of the path's time between two frames: a quarter of its speed at 25 a second

// How people are drawn. Close textures are as far as their memory reaches. `pictures`: the mean of so many, each moved
// by a part of a pixel, as `claque render --samples` draws them.
struct Manner {
    const char *name, *filter;
    int multisample;
    uint32_t close_mib, pictures;
};
constexpr Manner manners[] = {
    {"as it was", "nearest", 1, 0, 1},         {"smooth levels", "levels", 1, 0, 1},
    {"smooth, close", "levels", 1, 64, 1},     {"4 samples", "nearest", 4, 0, 1},
    {"4, smooth", "levels", 4, 0, 1},          {"4, smooth, close", "levels", 4, 64, 1},
    {"2 pictures", "nearest", 1, 0, 2},        {"4 pictures, smooth", "levels", 1, 0, 4},
    {"8 pictures, smooth", "levels", 1, 0, 8},
};

// The squares of the steps between neighbouring pixels.
double steps_of(const Pixels &pixels, size_t width)
{
    const size_t row = 3 * width;
    double sum = 0;
    for (size_t i = 0; i + row < pixels.size(); ++i) {
        const double down = double(pixels[i + row]) - pixels[i];
        const double right = i % row + 3 < row ? double(pixels[i + 3]) - pixels[i] : 0;
        sum += right * right + down * down;
    }
    return sum;
}

std::vector<int> error_of(const Pixels &a, const Pixels &b)
{
    std::vector<int> out(a.size());
    for (size_t i = 0; i < a.size(); ++i) out[i] = int(a[i]) - int(b[i]);
    return out;
}

std::vector<Pixels> frames_of(scenes::SceneRenderer &renderer, const scenes::PathSection &section, int frames,
                              uint32_t pictures, uint32_t first = 1)
{
    renderer.make_current();
    const double middle_s = (section.start_s + section.end_s) / 2;
    renderer.hold_crowd(middle_s);
    std::vector<Pixels> out;
    for (int i = 0; i <= frames; ++i)
        out.push_back(renderer.picture(middle_s + (i - frames * 0.5) * slow_s, pictures, first));
    return out;
}

// Means over pixels and channels, of 255: of the error, and of its change from frame to frame.
Json measured(const std::vector<Pixels> &shown, const std::vector<Pixels> &reference, size_t width)
{
    double errors = 0, changes = 0, steps = 0, reference_steps = 0;
    std::vector<int> before;
    for (size_t i = 0; i < shown.size(); ++i) {
        const std::vector<int> now = error_of(shown[i], reference[i]);
        steps += steps_of(shown[i], width), reference_steps += steps_of(reference[i], width);
        for (size_t k = 0; k < before.size(); ++k) errors += std::abs(now[k]), changes += std::abs(now[k] - before[k]);
        before = now;
    }
    const double all = static_cast<double>(before.size() * (shown.size() - 1));
    return {{"error", errors / all}, {"flicker", changes / all}, {"sharpness", std::sqrt(steps / reference_steps)}};
}

}  // namespace

bool is_of_flicker(const BenchArguments &a) { return a.subject == "flicker"; }

Json bench_flicker(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.setup));
    Json report = {{"claque", version()}, {"kind", "flicker"}, {"frames", a.frames}};
    report["runs"] = Json::array();
    report["size_px"] = {a.setup.width, a.setup.height};
    const auto renderer_of = [&](const std::string &lod, const Manner &manner) {
        SceneArguments arguments = a.setup;
        arguments.scene = "odeon", arguments.camera = "path", arguments.lod = lod;
        arguments.filter = manner.filter, arguments.multisample = manner.multisample,
        arguments.close_mib = manner.close_mib;
        arguments.close_distance_m = 1e6;
        return std::make_unique<scenes::SceneRenderer>(library, scene_options(arguments, LoadedCharacter()));
    };
    for (const std::string &lod : a.lods) {
        std::vector<std::vector<Pixels>> references;
        for (const Manner &manner : manners) {
            const auto renderer = renderer_of(lod, manner);
            report["context"] = renderer->context_name();
            const std::vector<scenes::PathSection> &sections = renderer->path()->sections();
            for (size_t i = 0; i < sections.size(); ++i) {
                // The first manner has one sample a pixel and the templates' own images.
                if (&manner == manners)
                    references.push_back(frames_of(*renderer, sections[i], a.frames, samples, first_sample));
                Json run = {{"section", sections[i].name}, {"levels", lod == "on"}, {"people", manner.name}};
                run.update(measured(frames_of(*renderer, sections[i], a.frames, manner.pictures), references[i],
                                    static_cast<size_t>(a.setup.width)));
                report["runs"].push_back(std::move(run));
                progress.step(report["runs"].size(), a.lods.size() * std::size(manners) * sections.size());
            }
        }
    }
    return report;
}

void print_flicker(const Json &report)
{
    std::printf("odeon, %d x %d, %s, %d frames a section\n%-19s %-7s %-15s %8s %8s %9s\n",
                report["size_px"][0].get<int>(), report["size_px"][1].get<int>(),
                report["context"].get<std::string>().c_str(), report["frames"].get<int>(), "people", "levels",
                "section", "error", "flicker", "sharpness");
    for (const Json &run : report["runs"])
        std::printf("%-19s %-7s %-15s %8.3f %8.3f %9.3f\n", run["people"].get<std::string>().c_str(),
                    run["levels"].get<bool>() ? "on" : "off", run["section"].get<std::string>().c_str(),
                    run["error"].get<double>(), run["flicker"].get<double>(), run["sharpness"].get<double>());
    std::printf(
        "Means over pixels and channels, of 255: the error of a frame against 16 samples, and its change.\n"
        "Sharpness: the steps between neighbouring pixels, as a part of those of the 16 samples.\n");
}

}  // namespace cli
