// claque bench vertex_format: skinned vertices as floats and packed, side by side: bytes for each individual, cost of
// an update and of a draw, and how many pixels of the picture differ by how much.
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "samples/cli/bench.h"
#include "samples/cli/progress.h"
#include "samples/cli/timed_parts.h"

namespace cli
{
namespace
{

struct Shown {
    const char *scene, *camera;
};
constexpr Shown shown[] = {{"plaza", "close"}, {"plaza", "overview"}, {"odeon", "close"}, {"odeon", "overview"}};
const char *const geometries[] = {"float", "packed"};

struct VertexFormatRival {
    std::unique_ptr<scenes::SceneRenderer> scene_renderer;
    Times update, draw;
    std::vector<uint8_t> picture;
};

// Pixels that differ in any channel; those that differ visibly; and the largest difference of one channel.
struct Difference {
    size_t pixels = 0, seen = 0;
    int most = 0;
    void add(const std::vector<uint8_t> &a, const std::vector<uint8_t> &b)
    {
        for (size_t i = 0; i + 2 < a.size(); i += 3) {
            int here = 0;
            for (size_t c = i; c < i + 3; ++c) here = std::max(here, std::abs(int(a[c]) - int(b[c])));
            pixels += here > 0;
            seen += here > 8;
            most = std::max(most, here);
        }
    }
};

void frame(VertexFormatRival &rival, double time_s)
{
    rival.scene_renderer->make_current();
    const Stopwatch updating;
    rival.scene_renderer->update(time_s);
    rival.update.ms.push_back(updating.ms());
    rival.draw.ms.push_back(timed_crowd(*rival.scene_renderer));
    rival.picture = rival.scene_renderer->read();
}

Json run(const BenchArguments &a, scenes::Library &library, const Shown &what)
{
    const LoadedCharacter none;
    VertexFormatRival rivals[2];
    for (int g = 0; g < 2; ++g) {
        SceneArguments arguments = a.setup;
        arguments.scene = what.scene;
        arguments.camera = what.camera;
        arguments.vertex_format = geometries[g];
        rivals[g].scene_renderer = std::make_unique<scenes::SceneRenderer>(library, scene_options(arguments, none));
        rivals[g].scene_renderer->update(1);
        rivals[g].scene_renderer->draw_frame();
    }
    Difference difference;
    for (int f = 0; f < a.frames; ++f) {
        for (int g = 0; g < 2; ++g) frame(rivals[(g + f) % 2], 1.5 + f / 25.0);
        difference.add(rivals[0].picture, rivals[1].picture);
    }
    Json report = {{"scene", what.scene}, {"camera", what.camera}};
    report["visible"] = rivals[0].scene_renderer->crowd_stats().visible;
    report["differing_pixels"] = double(difference.pixels) / a.frames / (a.setup.width * a.setup.height);
    report["pixels_differing_by_more_than_8"] = double(difference.seen) / a.frames / (a.setup.width * a.setup.height);
    report["largest_difference"] = difference.most;
    for (int g = 0; g < 2; ++g) {
        const clq_crowd_stats stats = rivals[g].scene_renderer->crowd_stats();
        report[geometries[g]] = {
            {"bytes_each", double(stats.cache_bytes) / std::max(1u, stats.visible)},
            {"update_ms", {{"minimum", rivals[g].update.minimum()}, {"median", rivals[g].update.median()}}},
            {"draw_ms", {{"minimum", rivals[g].draw.minimum()}, {"median", rivals[g].draw.median()}}}};
    }
    return report;
}

}  // namespace

Json bench_vertex_format(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.setup));
    Json report = {{"claque", version()}, {"threads", thread_count(a.setup)}, {"frames", a.frames}};
    report["size_px"] = {a.setup.width, a.setup.height};
    report["runs"] = Json::array();
    for (const Shown &what : shown) {
        progress.phase(std::string(what.scene) + ", " + what.camera);
        report["runs"].push_back(run(a, library, what));
    }
    return report;
}

void print_vertex_format(const Json &report)
{
    std::printf("%-8s %-9s %7s | %-22s | %-25s | %-25s | %s\n", "scene", "camera", "visible", "cache bytes each",
                "update ms, minimum", "draw ms, minimum", "pixels that differ");
    for (const Json &run : report["runs"]) {
        const Json &real = run["float"], &packed = run["packed"];
        const auto both = [&](const char *name) {
            return std::pair(real[name]["minimum"].get<double>(), packed[name]["minimum"].get<double>());
        };
        const auto [update_a, update_b] = both("update_ms");
        const auto [draw_a, draw_b] = both("draw_ms");
        const double a = real["bytes_each"].get<double>(), b = packed["bytes_each"].get<double>();
        std::printf(
            "%-8s %-9s %7u | %6.0f %6.0f  x %.2f | %7.3f %7.3f  x %.2f | %7.2f %7.2f  x %.2f | %.2f %%, more than 8 of "
            "255: %.3f %%, most %d\n",
            run["scene"].get<std::string>().c_str(), run["camera"].get<std::string>().c_str(),
            run["visible"].get<unsigned>(), a, b, b / a, update_a, update_b, update_b / update_a, draw_a, draw_b,
            draw_b / draw_a, 100 * run["differing_pixels"].get<double>(),
            100 * run["pixels_differing_by_more_than_8"].get<double>(), run["largest_difference"].get<int>());
    }
    std::printf("Floats first, then packed, and their ratio.\n");
}

}  // namespace cli
