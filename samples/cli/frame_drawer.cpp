#include "samples/cli/frame_drawer.h"

#include <array>
#include <cstdio>

#include "samples/cli/clip_choice.h"
#include "samples/cli/stopwatch.h"
#include "samples/io/png.h"
#include "samples/scenes/template_names.h"

namespace cli
{

FrameDrawer::FrameDrawer(const RenderArguments &a, int threads, processes::Ranks *ranks)
    : arguments_(a), library_(threads), options_(scene_options(a.setup, loaded_))
{
    if (ranks) library_.share_templates(ranks->rank() == 0, [ranks](std::string &bytes) { ranks->broadcast(bytes); });
}

const Subject &FrameDrawer::subject()
{
    if (scene_renderer_) return subject_;
    const RenderArguments &a = arguments_;
    if (!a.setup.file.empty())
        loaded_ = load_character(library_, a.setup.file, a.setup.of_file, a.clips, levels_of_file(a.setup));
    if (!a.clip.empty()) {
        loaded_.first_clip = clip_named(a.clip, scenes::names_of_clips(loaded_.tmpl.get()), a.setup.file);
        loaded_.one_clip = true;
    }
    options_ = scene_options(a.setup, loaded_);
    options_.crowd_options.as_shown = true;
    scene_renderer_.emplace(library_, options_);
    wardrobe_.emplace(library_, a.setup.colours, a.reload, options_.crowd_options.seed);
    subject_ = {scene_renderer_->crowd_stats().actor_count, scene_renderer_->context_name()};
    return subject_;
}

const std::vector<uint8_t> &FrameDrawer::draw(const Frame &frame, Json &report)
{
    subject();
    scenes::SceneRenderer &scene = *scene_renderer_;
    wardrobe_->apply_to(scene);
    const Stopwatch updating;
    scene.update(frame.time_s);
    const double update_ms = updating.ms();
    using Part = scenes::SceneRenderer::Part;
    std::array<double, 3> ms = {};
    scene.draw_apart([&](Part part, auto draw) {
        const Stopwatch watch;
        draw();
        ms[static_cast<size_t>(part)] = watch.ms();
    });
    const clq_draw_stats drawn = scene.drawn();
    const std::vector<uint8_t> &rgb =
        arguments_.samples > 1 ? scene.picture(frame.time_s, arguments_.samples) : scene.read();
    const clq_view_stats seen = scene.view_stats();
    report["update_ms"] = update_ms;
    report["environment_ms"] = ms[static_cast<size_t>(Part::environment)];
    report["draw_ms"] = ms[static_cast<size_t>(Part::crowd)];
    report["drawn"] = {{"individuals", drawn.individuals},
                       {"draws", drawn.draws},
                       {"triangles_seen", seen.triangles},
                       {"triangles_sent", drawn.triangles},
                       {"vertices_sent", drawn.vertices}};
    if (options_.close_texture_bytes != 0)
        report["close_textures"] = {{"individuals", drawn.close_individuals},
                                    {"made", drawn.close_textures_made},
                                    {"bytes", drawn.close_texture_bytes}};
    if (options_.shadows.form != scenes::ShadowChoice::Form::painted)
        report["shadows"] = shadow_counters(scene.darkened()),
        report["shadow_ms"] = ms[static_cast<size_t>(Part::shadows)];
    if (const std::optional<scenes::ReadPart> part = scene.scene().read_part())
        report["read"] = {{"what", part->unit}, {"read", part->read}, {"of", part->of}};
    report["counters"] = counters(scene.crowd_stats());
    return rgb;
}

// Hashing the list takes a seventh of the processor time of a picture of 50 000 people.
void FrameDrawer::add_hashes(const std::vector<uint8_t> &rgb, Json &report) const
{
    if (arguments_.json.empty()) return;
    report["picture_hash"] = hex(scenes::hash_of(rgb.data(), rgb.size()));
    report["list_hash"] = hex(scene_renderer_->view_hash());
}

const std::vector<uint8_t> &FrameDrawer::draw(const Frame &frame, const processes::Tile &tile, Json &report)
{
    subject();
    scene_renderer_->show_tile(tile.x0, tile.x1);
    return draw(frame, report);
}

std::vector<unsigned char> frame_bytes(const RenderArguments &a, const Frame &frame, const uint8_t *rgb,
                                       const scenes::SceneOptions &options, const Subject &subject)
{
    const size_t size = 3 * static_cast<size_t>(options.width) * static_cast<size_t>(options.height);
    if (frame.path == "-") return {rgb, rgb + size};
    char time[32];
    std::snprintf(time, sizeof time, "%.6g", frame.time_s);
    io::Words words = {{"Software", "claque " + version()},
                       {"Description", options.scene + ", " + std::to_string(subject.count) + " individuals, seed " +
                                           std::to_string(options.crowd_options.seed) + ", time " + time + " s"},
                       {"Source", subject.context}};
    const std::string settings = frame_settings(a, frame);
    if (!settings.empty()) words.emplace_back(settings_keyword, settings);
    return io::png(rgb, options.width, options.height, words);
}

Json frame_report(const Frame &frame)
{
    Json report;
    if (frame.number >= 0) report["frame"] = frame.number;
    report["time_s"] = frame.time_s;
    if (frame.path != "-") report["file"] = frame.path;
    return report;
}

}  // namespace cli
