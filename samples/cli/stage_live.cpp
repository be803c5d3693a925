// claque stage --live: frames at the times of the machine's clock, and what they cost.
#include <chrono>
#include <iostream>
#include <thread>

#include "samples/cli/stage_work.h"
#include "samples/cli/stopwatch.h"
#include "samples/stage/takeover.h"

namespace cli
{
namespace
{

Json summary(const Times &times)
{
    double most = 0;
    for (const double ms : times.ms) most = std::max(most, ms);
    return {{"min", times.minimum()}, {"median", times.median()}, {"max", most}};
}

// What changes while the run is shown, if its file is watched.
class Watch
{
public:
    Watch(scenes::Library &library, const StageArguments &a)
        : library_(library),
          arguments_(a),
          takeover_(library, options_of(a), a.setup.scenario, *a.setup.described, stage_options(a))
    {
    }

    void look(double now_s, std::unique_ptr<OpenRun> &run)
    {
        takeover_.look(now_s);
        if (const std::unique_ptr<staged::Takeover::Made> made = takeover_.take()) {
            arguments_.setup.described = std::make_shared<const scenes::Scenario>(made->scenario);
            run.reset();  // and its GL context
            run = std::make_unique<OpenRun>(library_, arguments_, std::move(made->scene));
            taken_.push_back(now_s);
        }
        const std::string refusal = takeover_.refusal();
        if (refusal.empty()) return;
        std::cerr << "claque: " << refusal << (refusal.back() == '.' ? "" : ".") << " The run goes on as it was.\n";
        refused_.push_back(refusal);
    }
    Json taken() const { return taken_; }
    Json refused() const { return refused_; }

private:
    static scenes::CrowdOptions options_of(const StageArguments &a)
    {
        LoadedCharacter loaded;
        return scene_options(a.setup, loaded).crowd_options;
    }

    scenes::Library &library_;
    StageArguments arguments_;
    staged::Takeover takeover_;
    Json taken_ = Json::array(), refused_ = Json::array();
};

}  // namespace

Json show_live(scenes::Library &library, const StageArguments &a, std::unique_ptr<OpenRun> &run, bool is_watched)
{
    std::optional<Watch> watch;
    if (is_watched) watch.emplace(library, a);
    const double begin_s = std::max(0.0, run->scene->run().shown_s());
    run->scene->rest();
    run->show(begin_s);
    run->scene->rest();
    Times frames, kept, behind;
    const Stopwatch clock;
    double looked_s = 0;
    for (int64_t frame = 1;;) {
        const double due_s = static_cast<double>(frame) / a.fps;
        if (begin_s + due_s > a.seconds) break;
        const double wait_s = due_s - clock.ms() / 1000;
        if (wait_s > 0) std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
        const Stopwatch drawing;
        const double now_s = clock.ms() / 1000;
        run->show(begin_s + now_s);
        frames.ms.push_back(drawing.ms());
        kept.ms.push_back(run->scene->kept_s() * 1000);
        behind.ms.push_back(run->scene->behind_s() * 1000);
        if (watch && now_s - looked_s > 0.25) watch->look(begin_s + now_s, run), looked_s = now_s;
        frame = std::max(frame + 1, static_cast<int64_t>(clock.ms() / 1000 * a.fps));
    }
    const double seconds = clock.ms() / 1000;
    return {{"frames", frames.ms.size()},
            {"frames_per_s", static_cast<double>(frames.ms.size()) / seconds},
            {"frame_ms", summary(frames)},
            {"kept_by_decisions_ms", summary(kept)},
            {"decisions_behind_ms", summary(behind)},
            {"taken_over_s", watch ? watch->taken() : Json::array()},
            {"refused", watch ? watch->refused() : Json::array()}};
}

}  // namespace cli
