// claque bench along a camera path, in the manner of S1 7: each section by cache and by draw strategy. Every frame is
// drawn in all variants in a rotating order, so that other load on the machine affects them alike. Each cache has a
// crowd of its own. A frame is drawn whole, waiting for GL at its end, and once more in parts. Frames come in bursts,
// 1/25 s apart, spread over the section. Before a burst each crowd gets one unmeasured update, one frame earlier, so
// that its caches hold what they would hold on a continuous path.
#include <algorithm>
#include <map>
#include <memory>

#include "samples/cli/agreement.h"
#include "samples/cli/bench.h"
#include "samples/cli/machine.h"
#include "samples/cli/progress.h"
#include "samples/cli/stopwatch.h"

namespace cli
{
namespace
{

constexpr double frame_s = 1 / 25.0;
constexpr int burst_frames = 5;
constexpr const char *with_levels = ", levels";

struct Mean {
    double sum = 0;
    size_t count = 0;
    void add(double value)
    {
        sum += value;
        ++count;
    }
    double value() const { return count > 0 ? sum / static_cast<double>(count) : 0; }
};

// One cache and one draw strategy over one section.
struct Variant {
    Times update, environment, draw, frame;
    Mean draws, triangles_sent, vertices_sent, animated, skinned, asked, served, updated;
};

// One cache, with or without levels of detail: a crowd and a context of its own for all strategies.
struct PathRival {
    std::string cache;    // with levels, as in reports
    std::string picture;  // equal for rivals that show the same picture
    std::unique_ptr<scenes::SceneRenderer> scene_renderer;
    std::vector<Variant> variants;  // by draw strategy
};

struct Seen {
    uint32_t least = UINT32_MAX, most = 0;
    Mean people, triangles;
    void note(const clq_view_stats &view)
    {
        least = std::min(least, view.visible);
        most = std::max(most, view.visible);
        people.add(view.visible);
        triangles.add(view.triangles);
    }
};

Json spread(const Times &times) { return {{"minimum", times.minimum()}, {"median", times.median()}}; }

std::vector<std::vector<double>> bursts_of(const scenes::PathSection &section, int frames)
{
    const int count = (frames + burst_frames - 1) / burst_frames;
    std::vector<std::vector<double>> bursts;
    for (int b = 0; b < count; ++b) {
        const int here = frames * (b + 1) / count - frames * b / count;
        const double middle = section.start_s + (section.end_s - section.start_s) * (b + 0.5) / count;
        bursts.emplace_back();
        for (int f = 0; f < here; ++f) bursts.back().push_back(middle + (f - (here - 1) * 0.5) * frame_s);
    }
    return bursts;
}

class Race
{
public:
    Race(const BenchArguments &a, scenes::Library &library, Progress &progress) : a_(a)
    {
        const LoadedCharacter none;
        for (const std::string &lod : a.lods)
            for (const std::string &cache : a.caches) {
                // Reports name levels where there are people without them too.
                const std::string form = a.lods.size() > 1 && lod == "on" ? with_levels : "";
                const std::string label = cache + form;
                progress.phase("preparing, cache " + label);
                SceneArguments arguments = a.setup;
                arguments.cache = cache;
                arguments.lod = lod;
                const scenes::SceneOptions options = scene_options(arguments, none);
                rivals_.push_back(
                    {label, picture_of(cache) + form, std::make_unique<scenes::SceneRenderer>(library, options), {}});
                // The first draws of a renderer cost more than later ones.
                rivals_.back().scene_renderer->update(options.path->start_s());
                for (const std::string &strategy : a.strategies) {
                    rivals_.back().scene_renderer->use_strategy(strategy_named(strategy));
                    rivals_.back().scene_renderer->draw_frame();
                }
            }
    }

    const scenes::SceneRenderer &scene_renderer() const { return *rivals_.front().scene_renderer; }

    void begin(const std::string &section)
    {
        section_ = section;
        seen_ = {};
        agreements_.clear();
        hashes_.clear();
        for (PathRival &rival : rivals_) rival.variants.assign(a_.strategies.size(), {});
    }

    void burst(const std::vector<double> &times_s)
    {
        for (PathRival &rival : rivals_) {
            rival.scene_renderer->make_current();
            rival.scene_renderer->update(times_s.front() - frame_s);
        }
        for (const double time_s : times_s) {
            for (const PathRival &rival : rivals_)
                agreements_[rival.picture].begin("section '" + section_ + "' at " + std::to_string(time_s) + " s");
            for (size_t i = 0; i < rivals_.size(); ++i) frame(rivals_[(i + turn_) % rivals_.size()], time_s);
            for (const auto &[picture, agreement] : agreements_) hashes_ += agreement.hash();
            seen_.note(scene_renderer().view_stats());
            ++turn_;
        }
    }

    Json section_report(const scenes::PathSection &section) const
    {
        return {{"name", section.name},
                {"start_s", section.start_s},
                {"end_s", section.end_s},
                {"people", {{"minimum", seen_.least}, {"mean", seen_.people.value()}, {"maximum", seen_.most}}},
                {"triangles", seen_.triangles.value()},
                {"depth_ties", max_ties()},
                {"pictures_hash", hex(scenes::hash_of({hashes_.begin(), hashes_.end()}))}};
    }

    void report_runs(Json &runs) const
    {
        for (const PathRival &rival : rivals_)
            for (size_t v = 0; v < a_.strategies.size(); ++v) {
                const Variant &variant = rival.variants[v];
                runs.push_back({{"section", section_},
                                {"cache", rival.cache},
                                {"strategy", a_.strategies[v]},
                                {"update_ms", spread(variant.update)},
                                {"environment_ms", spread(variant.environment)},
                                {"draw_ms", spread(variant.draw)},
                                {"frame_ms", spread(variant.frame)},
                                {"draws", variant.draws.value()},
                                {"triangles_sent", variant.triangles_sent.value()},
                                {"vertices_sent", variant.vertices_sent.value()},
                                {"animated", variant.animated.value()},
                                {"skinned", variant.skinned.value()},
                                {"key_poses_requested", variant.asked.value()},
                                {"key_poses_served", variant.served.value()},
                                {"key_poses_updated", variant.updated.value()}});
            }
    }

private:
    size_t max_ties() const
    {
        size_t most = 0;
        for (const auto &[picture, agreement] : agreements_) most = std::max(most, agreement.max_ties());
        return most;
    }

    using Part = scenes::SceneRenderer::Part;

    // One update, which all strategies share, and a picture with each strategy.
    void frame(PathRival &rival, double time_s)
    {
        scenes::SceneRenderer &scene_renderer = *rival.scene_renderer;
        scene_renderer.make_current();
        const Stopwatch updating;
        scene_renderer.update(time_s);
        const double update_ms = updating.ms();
        const clq_crowd_stats stats = scene_renderer.crowd_stats();
        clq_key_pose_stats key_poses = clq_key_pose_stats_init();
        scenes::check(clq_crowd_get_key_pose_stats(scene_renderer.scene().crowd(), &key_poses));
        for (size_t i = 0; i < a_.strategies.size(); ++i) {
            const size_t v = (i + turn_) % a_.strategies.size();
            Variant &variant = rival.variants[v];
            scene_renderer.use_strategy(strategy_named(a_.strategies[v]));
            const Stopwatch whole;
            scene_renderer.draw_frame();
            const double whole_ms = whole.ms();
            double environment_ms = 0, draw_ms = 0;
            scene_renderer.draw_apart([&](Part part, auto draw) {
                const Stopwatch watch;
                draw();
                if (part == Part::environment) environment_ms = watch.ms();
                if (part == Part::crowd) draw_ms = watch.ms();
            });
            const clq_draw_stats &drawn = scene_renderer.drawn();
            variant.update.ms.push_back(update_ms);
            variant.environment.ms.push_back(environment_ms);
            variant.draw.ms.push_back(draw_ms);
            variant.frame.ms.push_back(update_ms + whole_ms);
            variant.draws.add(drawn.draws);
            variant.triangles_sent.add(static_cast<double>(drawn.triangles));
            variant.vertices_sent.add(static_cast<double>(drawn.vertices));
            variant.animated.add(stats.animated);
            variant.skinned.add(stats.skinned);
            variant.asked.add(key_poses.requested);
            variant.served.add(key_poses.served);
            variant.updated.add(key_poses.updated);
            agreements_[rival.picture].check(scene_renderer.read(), rival.cache, a_.strategies[v]);
        }
    }

    const BenchArguments &a_;
    std::vector<PathRival> rivals_;
    std::string section_;
    Seen seen_;
    std::map<std::string, Agreement> agreements_;  // by what the rivals show
    std::string hashes_;                           // of all pictures of the section
    size_t turn_ = 0;
};

}  // namespace

Json bench_along_path(const BenchArguments &a)
{
    Progress progress("claque bench");
    scenes::Library library(thread_count(a.setup));
    Race race(a, library, progress);
    const std::vector<scenes::PathSection> &sections = race.scene_renderer().path()->sections();
    if (sections.empty()) throw scenes::Failure(a.setup.path + ": the camera path has no sections to measure");
    Json report = {{"claque", version()},
                   {"scene", scene_of(a.setup)},
                   {"count", race.scene_renderer().crowd_stats().actor_count},
                   {"size_px", {a.setup.width, a.setup.height}},
                   {"threads", thread_count(a.setup)},
                   {"context", race.scene_renderer().context_name()},
                   {"machine", machine()},
                   {"frames", a.frames},
                   {"lod", a.lods},
                   {"burst_frames", std::min(a.frames, burst_frames)}};
    report["sections"] = Json::array();
    report["runs"] = Json::array();
    for (const scenes::PathSection &section : sections) {
        race.begin(section.name);
        const std::vector<std::vector<double>> bursts = bursts_of(section, a.frames);
        for (size_t b = 0; b < bursts.size(); ++b) {
            race.burst(bursts[b]);
            progress.step(report["sections"].size() * bursts.size() + b + 1, sections.size() * bursts.size());
        }
        report["sections"].push_back(race.section_report(section));
        race.report_runs(report["runs"]);
    }
    return report;
}

}  // namespace cli
