// claque bench close_textures: what textures of single individuals cost (docs/colours.md). A field of citizens of 128 x
// 128 texels, all in view and all near enough, is drawn in one context: by the fused strategy, with a texture each, and
// with one texture for all, in which their template's own colours are.
#include <cstdio>

#include "samples/cli/bench.h"
#include "samples/cli/progress.h"
#include "samples/cli/stopwatch.h"

namespace cli
{
namespace
{

constexpr uint32_t texels = 128, across = 40;
constexpr uint64_t budget = uint64_t(4) << 30;

// The same people, each in colours of their own or all in the template's.
struct Field {
    Field(scenes::Library &library, clq_template *citizen, uint32_t count, bool coloured, double aspect)
        : cast(library, scenes::CrowdOptions())
    {
        for (uint32_t person = 0; person < count; ++person) {
            clq_play play = clq_play_init();
            play.clip = clq_template_find_clip(citizen, "stand");
            play.phase_s = 0.1f * static_cast<float>(person % 37);
            const double x = 1.2 * (person % across - 0.5 * (across - 1)), z = -1.2 * (person / across);
            cast.enter({citizen, scenes::stand(x, 0, z, 0, 1, 1), play});
        }
        if (!coloured) {
            clq_template_info info = clq_template_info_init();
            scenes::check(clq_template_get_info(citizen, &info));
            std::vector<float> rgb;
            for (uint32_t zone = 0; zone < info.zone_count; ++zone) {
                clq_zone_info about = clq_zone_info_init();
                scenes::check(clq_template_get_zone(citizen, zone, &about));
                rgb.insert(rgb.end(), about.colour, about.colour + 3);
            }
            for (const clq_actor actor : cast.actors())
                scenes::check(clq_actor_set_colours(cast.crowd(), actor, rgb.data(), info.zone_count));
        }
        clq_view *made = nullptr;
        scenes::check(clq_view_create(cast.crowd(), &made));
        view.reset(made);
        const double at[3] = {0, 14, 26}, ahead[3] = {0, 0, -0.6 * count / across};
        const clq_camera camera = scenes::look(at, ahead, 60, aspect, 0.5, 1000);
        scenes::check(clq_view_set_camera(made, &camera));
        clq_view *views[] = {made};
        scenes::check(clq_crowd_update(cast.crowd(), 2, views, 1));
    }
    scenes::SceneCrowd cast;
    scenes::Own<clq_view> view;
};

struct CloseRival {
    const char *name;
    const Field *field;
    scenes::Own<clq_renderer> renderer;
    Times draw = {};
    double first_ms = 0;
    clq_draw_stats first = clq_draw_stats_init(), last = clq_draw_stats_init();
};

void draw(CloseRival &rival, const scenes::Gl &gl, int frame)
{
    gl.Clear(scenes::gl::color_buffer_bit | scenes::gl::depth_buffer_bit);
    gl.Finish();
    const Stopwatch drawing;
    scenes::check(clq_renderer_draw(rival.renderer.get(), rival.field->view.get(), &rival.last));
    gl.Finish();
    if (frame == 0) rival.first_ms = drawing.ms(), rival.first = rival.last;
    else rival.draw.ms.push_back(drawing.ms());
}

scenes::Own<clq_renderer> renderer_for(const scenes::Library &library, const contexts::Offscreen &offscreen,
                                       clq_template *citizen, uint64_t close_texture_bytes)
{
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = offscreen.get_proc_address();
    def.user = offscreen.user();
    def.close_texture_bytes = close_texture_bytes, def.close_distance_m = 1e6f;
    clq_renderer *made = nullptr;
    scenes::check(clq_renderer_create(library.context(), &def, &made));
    scenes::Own<clq_renderer> renderer(made);
    scenes::check(clq_renderer_prepare(made, citizen));
    return renderer;
}

scenes::Own<clq_template> small_citizen(const scenes::Library &library)
{
    clq_asset *asset = nullptr;
    clq_template *tmpl = nullptr;
    scenes::check(clq_asset_builtin(library.context(), "citizen", &asset));
    const scenes::Own<clq_asset> kept(asset);
    scenes::check(clq_asset_build(library.context(), asset, texels, &tmpl));
    return scenes::Own<clq_template>(tmpl);
}

}  // namespace

Json bench_close_textures(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.setup));
    const scenes::SceneOptions options = scene_options(a.setup, LoadedCharacter());
    std::string why_not;
    const auto offscreen =
        contexts::make_offscreen(options.context, options.width, options.height, options.format, why_not);
    if (!offscreen) throw scenes::Failure("no OpenGL context: " + why_not);
    scenes::Gl gl;
    if (!load(gl, offscreen->get_proc_address(), offscreen->user(), why_not))
        throw scenes::Failure("this OpenGL context lacks " + why_not);
    const scenes::Own<clq_template> citizen = small_citizen(library);
    Json report = {{"claque", version()}, {"frames", a.frames}, {"context", offscreen->name()}};
    report["texels"] = {texels, texels};
    report["size_px"] = {options.width, options.height};
    report["runs"] = Json::array();
    for (const uint32_t count : a.counts) {
        const double aspect = double(options.width) / options.height;
        const Field coloured(library, citizen.get(), count, true, aspect);
        const Field alike(library, citizen.get(), count, false, aspect);
        CloseRival rivals[] = {{"fused", &coloured, renderer_for(library, *offscreen, citizen.get(), 0)},
                               {"own", &coloured, renderer_for(library, *offscreen, citizen.get(), budget)},
                               {"shared", &alike, renderer_for(library, *offscreen, citizen.get(), budget)}};
        for (int frame = 0; frame <= a.frames; ++frame) {
            for (size_t k = 0; k < 3; ++k) draw(rivals[(k + static_cast<size_t>(frame)) % 3], gl, frame);
            progress.step(static_cast<size_t>(frame), static_cast<size_t>(a.frames));
        }
        Json run = {{"count", count}};
        for (const CloseRival &rival : rivals)
            run[rival.name] = {{"draw_ms", {{"minimum", rival.draw.minimum()}, {"median", rival.draw.median()}}},
                               {"first_draw_ms", rival.first_ms},
                               {"individuals", rival.last.individuals},
                               {"with_own", rival.last.close_individuals},
                               {"made", rival.first.close_textures_made},
                               {"bytes", rival.last.close_texture_bytes},
                               {"triangles", rival.last.triangles},
                               {"vertices", rival.last.vertices}};
        report["runs"].push_back(run);
    }
    return report;
}

void print_close_textures(const Json &report)
{
    std::printf("%s, %d frames; milliseconds a draw, minimum / median, and their ratios to one texture for all\n",
                report["context"].get<std::string>().c_str(), report["frames"].get<int>());
    for (const Json &run : report["runs"]) {
        const auto ms = [&](const char *name, const char *which) { return run[name]["draw_ms"][which].get<double>(); };
        std::printf("%u people\n", run["count"].get<unsigned>());
        for (const char *name : {"shared", "own", "fused"})
            std::printf(
                "  %-6s %8.2f / %8.2f  x %.2f / %.2f  %7u triangles, %5u textures of %.1f MiB, first draw %.1f\n", name,
                ms(name, "minimum"), ms(name, "median"), ms(name, "minimum") / ms("shared", "minimum"),
                ms(name, "median") / ms("shared", "median"), run[name]["triangles"].get<unsigned>(),
                run[name]["made"].get<unsigned>(), run[name]["bytes"].get<double>() / (1 << 20),
                run[name]["first_draw_ms"].get<double>());
    }
    std::printf(
        "shared: one texture for all, in the template's colours; own: a texture for each; fused: the strategy.\n");
}

}  // namespace cli
