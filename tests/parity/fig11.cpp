// S2's Fig. 11: individuals in view against frames per second, drawn by the CPU path and by the peer's shaders, side by
// side in one run and on the same OpenGL.
//   fig11 [--counts 100,300,1000] [--lod on|off] [--frames N] [--width W] [--height H] [--save chart.json]
// prints a table; the chart is for claque plot.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "samples/charts/lines.h"
#include "samples/cli/stopwatch.h"
#include "samples/parity/write/write.h"
#include "tests/parity/live_peer.h"

namespace
{

namespace fs = std::filesystem;

struct Arguments {
    std::vector<uint32_t> counts = {100, 300, 1000, 3000, 10000};
    int frames = 15;
    int width = 1024, height = 768;
    bool levels = true;
    std::string scene = "ten_thousand", save;
};

// Of whole frames, milliseconds: time of the library, and time of OpenGL.
struct Measured {
    cli::Times update, draw, frame;

    void add(double update_ms, double draw_ms)
    {
        update.ms.push_back(update_ms), draw.ms.push_back(draw_ms), frame.ms.push_back(update_ms + draw_ms);
    }
    // S2 6: the mean of the lowest and the highest rate.
    double frames_a_second() const
    {
        const auto [low, high] = std::minmax_element(frame.ms.begin(), frame.ms.end());
        return (1000 / *low + 1000 / *high) / 2;
    }
};

scenes::SceneOptions options_of(const Arguments &a, uint32_t count)
{
    scenes::SceneOptions options;
    options.scene = a.scene;
    options.crowd_options.count = count;
    options.crowd_options.lod = scenes::Lod::on;
    options.crowd_options.lod_scale = a.levels ? 1 : 0;
    options.width = a.width, options.height = a.height;
    return options;
}

void clear(scenes::SceneRenderer &scene_renderer)
{
    scene_renderer.begin_picture();
    scene_renderer.gl().Finish();
}

// The ways of the CPU path. The first two share a crowd; each other has its own.
enum Way { per_zone, fused, fused_packed, fused_uncached, cpu_ways };
constexpr const char *way_names[cpu_ways] = {"a pass a zone", "fused", "fused, packed", "fused, no caches"};

// One update, drawn once for each strategy.
void cpu_frame(scenes::SceneRenderer &scene_renderer, double time_s,
               const std::vector<std::pair<clq_draw_strategy, Measured *>> &draws)
{
    scene_renderer.make_current();
    const cli::Stopwatch updating;
    scene_renderer.update(time_s);
    const double update_ms = updating.ms();
    for (const auto &[strategy, out] : draws) {
        scene_renderer.use_strategy(strategy);
        clear(scene_renderer);
        const cli::Stopwatch drawing;
        scene_renderer.draw_crowd();
        if (out) out->add(update_ms, drawing.ms());
    }
}

void shader_frame(scenes::SceneRenderer &scene_renderer, parity_test::LivePeer &peer, double time_s, Measured *out)
{
    scene_renderer.make_current();
    const cli::Stopwatch updating;
    scene_renderer.update(time_s);
    const double update_ms = updating.ms();
    peer.begin();
    const cli::Stopwatch drawing;
    peer.draw(scene_renderer.view());
    if (out) out->add(update_ms, drawing.ms());
}

struct Row {
    uint32_t people = 0;
    Measured cpu[cpu_ways], shaders;
};

// Memory for every palette and for almost no vertices: actors without cached vertices are skinned only when their
// vertices are requested, which does not happen here. The deformation is the shader's.
uint64_t palette_bytes(scenes::SceneRenderer &scene_renderer)
{
    scene_renderer.update(2);
    uint64_t bytes = 0;
    for (uint32_t i = 0; i < scene_renderer.view_stats().visible; ++i) {
        clq_drawn_actor shown = clq_drawn_actor_init();
        clq_template_info info = clq_template_info_init();
        scenes::check(clq_view_get_drawn_actor(scene_renderer.view(), i, &shown));
        scenes::check(clq_template_get_info(shown.tmpl, &info));
        bytes +=
            (sizeof(float) * (12 * std::max(info.node_count, info.joint_count) + shown.morph_weight_count + 4) + 63) /
            64 * 64;
    }
    return bytes + bytes / 32 + 65536;
}

void expect_unskinned(const scenes::SceneRenderer &scene_renderer)
{
    const clq_crowd_stats stats = scene_renderer.crowd_stats();
    if (stats.skinned > stats.visible / 20 || stats.palette_served + stats.animated < stats.visible)
        throw scenes::Failure("the shader path's update skinned " + std::to_string(stats.skinned) + " and kept " +
                              std::to_string(stats.palette_served + stats.animated) + " palettes of " +
                              std::to_string(stats.visible));
}

// Alternating, so that all meet the same machine; the first frame of each fills caches and compiles.
Row measure(const Arguments &a, scenes::Library &library, uint32_t count, const std::string &folder)
{
    scenes::SceneRenderer cached(library, options_of(a, count));
    scenes::SceneOptions options = options_of(a, count);
    options.crowd_options.cache_budget_bytes = palette_bytes(cached);
    scenes::SceneRenderer palettes(library, options);
    options = options_of(a, count);
    options.crowd_options.vertex_format = CLQ_VERTEX_PACKED;
    scenes::SceneRenderer packed(library, options);
    options = options_of(a, count);
    options.crowd_options.cache = CLQ_CACHE_NONE;
    scenes::SceneRenderer uncached(library, options);

    palettes.make_current();
    parity::write_scene(palettes, {a.scene, 0, a.width, a.height}, folder);
    parity_test::LivePeer peer(palettes.offscreen(), folder, palettes.view());
    Row row;
    for (int frame = 0; frame <= a.frames; ++frame) {
        const double time_s = 2 + frame / 25.0;
        const auto kept = [&](Way way) { return frame ? &row.cpu[way] : nullptr; };
        cpu_frame(cached, time_s, {{CLQ_STRATEGY_PER_ZONE, kept(per_zone)}, {CLQ_STRATEGY_FUSED, kept(fused)}});
        cpu_frame(packed, time_s, {{CLQ_STRATEGY_FUSED, kept(fused_packed)}});
        cpu_frame(uncached, time_s, {{CLQ_STRATEGY_FUSED, kept(fused_uncached)}});
        shader_frame(palettes, peer, time_s, frame ? &row.shaders : nullptr);
        expect_unskinned(palettes);
    }
    row.people = cached.view_stats().visible;
    return row;
}

void print(const std::vector<Row> &rows, const std::string &context)
{
    std::printf("%s; milliseconds (medians)\n\n| people in view |", context.c_str());
    for (const char *name : way_names) std::printf(" %s: update | draw | frames/s |", name);
    std::printf(" shaders: update | draw | frames/s | fused / shaders |\n|---|");
    for (int column = 0; column < 3 * (cpu_ways + 1) + 1; ++column) std::printf("---|");
    std::printf("\n");
    for (const Row &row : rows) {
        std::printf("| %u |", row.people);
        const auto cells = [](const Measured &m) {
            std::printf(" %.3g | %.3g | %.3g |", m.update.median(), m.draw.median(), m.frames_a_second());
        };
        for (const Measured &m : row.cpu) cells(m);
        cells(row.shaders);
        std::printf(" %.2f |\n", row.cpu[fused].frames_a_second() / row.shaders.frames_a_second());
    }
}

charts::LineChart chart_of(const Arguments &a, const std::vector<Row> &rows, const std::string &context)
{
    charts::LineChart chart;
    chart.title = "CPU path and shader path: frames a second by people in view";
    chart.subtitle = a.scene + (a.levels ? ", levels, " : ", no levels, ") + std::to_string(a.width) + " x " +
                     std::to_string(a.height) + ", " + context;
    chart.x = {"people in view", charts::Scale::logarithmic, {}, {}};
    chart.y = {"frames a second", charts::Scale::logarithmic, {}, {}};
    const auto add = [&](const std::string &name, auto measured) {
        charts::Series series;
        series.name = name;
        for (const Row &row : rows)
            series.points.push_back({static_cast<double>(row.people), measured(row).frames_a_second()});
        chart.series.push_back(series);
    };
    for (const Way way : {per_zone, fused, fused_packed, fused_uncached})
        add("CPU path, " + std::string(way_names[way]),
            [&](const Row &row) -> const Measured & { return row.cpu[way]; });
    add("shader path", [](const Row &row) -> const Measured & { return row.shaders; });
    chart.note =
        "In the manner of S2's Fig. 11: the mean of the lowest and the highest rate; both paths on the same OpenGL.";
    return chart;
}

void run(const Arguments &a)
{
    const fs::path folder = fs::temp_directory_path() / ("claque-fig11-" + std::to_string(getpid()));
    scenes::Library library(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
    std::vector<Row> rows;
    std::string context;
    for (const uint32_t count : a.counts) {
        std::cerr << "fig11: " << count << " people\n";
        rows.push_back(measure(a, library, count, folder.string()));
        fs::remove_all(folder);
    }
    std::string why_not;
    if (const auto offscreen =
            contexts::make_offscreen(contexts::Kind::any, 16, 16, contexts::PixelFormat::rgba8888, why_not))
        context = offscreen->name();
    print(rows, context);
    if (a.save.empty()) return;
    std::ofstream file(a.save);
    file << charts::json_of(chart_of(a, rows, context));
    if (!file) throw scenes::Failure(a.save + " could not be written");
}

}  // namespace

int main(int argc, char **argv)
{
    Arguments a;
    CLI::App app("S2's Fig. 11: the CPU path against the shader path.");
    app.add_option("--scene", a.scene, "As claque render has them");
    app.add_option("--counts", a.counts, "People, several runs")->delimiter(',')->check(CLI::Range(1, 1000000));
    app.add_option_function<std::string>(
           "--lod", [&](const std::string &lod) { a.levels = lod == "on"; },
           "Levels of detail (default on); off: all at their finest")
        ->check(CLI::IsMember({"off", "on"}));
    app.add_option("--frames", a.frames, "Of each kind and count")->check(CLI::Range(1, 10000));
    app.add_option("--width", a.width, "Of the picture")->check(CLI::Range(16, 16384));
    app.add_option("--height", a.height, "Of the picture")->check(CLI::Range(16, 16384));
    app.add_option("--save", a.save, "The chart, for claque plot");
    CLI11_PARSE(app, argc, argv);
    try {
        run(a);
        return 0;
    } catch (const std::exception &error) {
        std::cerr << "fig11: " << error.what() << "\n";
        return 1;
    }
}
