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
          takeover_(library, options_of(a), a.setup.scenario, *a.setup.described, stage_options(a),
                    [setup = a.setup]() mutable {  // with the placement that the command gives
                        read_scenario(setup);
                        return *setup.described;
                    })
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

// The time of the run: the machine's, but for pauses, steps and states that are restored.
class Pace
{
public:
    Pace(const StageArguments &a, StageCommands *commands, double begin_s)
        : arguments_(a), commands_(commands), offset_s_(begin_s)
    {
    }

    double clock_s() const { return clock_.ms() / 1000; }
    double now_s() const { return clock_s() + offset_s_; }
    double offset_s() const { return offset_s_; }

    // Obeys what has come; in a pause waits for more. False: the run ends.
    bool obey(OpenRun &run)
    {
        if (!commands_) return true;
        bool pauses = false;
        double since_s = now_s();
        for (;;) {
            std::optional<StageCommand> command;
            try {
                command = pauses ? commands_->wait() : commands_->poll();
                if (!command) break;
                if (command->kind == StageCommand::Kind::end) return false;
                if (!pauses) since_s = now_s();
                pauses = take(run, *command, pauses, since_s);
            } catch (const scenes::Failure &failure) {
                std::cerr << "claque: " << failure.what() << ". The run goes on as it was.\n";
                continue;
            }
            if (pauses) offset_s_ += since_s - now_s();
        }
        if (pauses) offset_s_ += since_s - now_s();
        return true;
    }

private:
    // Whether the clock stands still afterwards, at since_s.
    bool take(OpenRun &run, const StageCommand &command, bool pauses, double &since_s)
    {
        using Kind = StageCommand::Kind;
        if (command.kind == Kind::save) save_to(command.text, *run.scene);
        if (command.kind == Kind::send) run.scene->run().send_all(command.text, command.number);
        if (command.kind == Kind::restore) {
            restore_from(command.text, *run.scene);
            since_s = run.scene->run().shown_s();
            offset_s_ += since_s - now_s();
        }
        if (command.kind == Kind::step || command.kind == Kind::to) {
            since_s = command.kind == Kind::to ? std::max(since_s, command.number)
                                               : since_s + command.number / arguments_.fps;
            since_s = std::min(since_s, arguments_.seconds);
            run.show(since_s);
            return true;
        }
        if (command.kind == Kind::pause) return true;
        if (command.kind == Kind::go && pauses) offset_s_ += since_s - now_s();
        return pauses && command.kind != Kind::go;
    }

    const StageArguments &arguments_;
    StageCommands *commands_;
    double offset_s_;
    const Stopwatch clock_;
};

}  // namespace

Json show_live(scenes::Library &library, const StageArguments &a, std::unique_ptr<OpenRun> &run, bool is_watched,
               StageCommands *commands)
{
    std::optional<Watch> watch;
    if (is_watched) watch.emplace(library, a);
    const double begin_s = std::max(0.0, run->scene->run().shown_s());
    run->scene->rest();
    run->show(begin_s);
    run->scene->rest();
    Times frames, kept, behind;
    Pace pace(a, commands, begin_s);
    double looked_s = 0;
    for (int64_t frame = 1; pace.obey(*run);) {
        const double due_s = static_cast<double>(frame) / a.fps;
        if (due_s + pace.offset_s() > a.seconds) break;
        const double wait_s = due_s - pace.clock_s();
        if (wait_s > 0) std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
        const Stopwatch drawing;
        const double clock_s = pace.clock_s(), now_s = pace.now_s();
        run->show(now_s);
        frames.ms.push_back(drawing.ms());
        kept.ms.push_back(run->scene->kept_s() * 1000);
        behind.ms.push_back(run->scene->behind_s() * 1000);
        if (watch && clock_s - looked_s > 0.25) watch->look(now_s, run), looked_s = clock_s;
        frame = std::max(frame + 1, static_cast<int64_t>(pace.clock_s() * a.fps));
    }
    const double seconds = pace.clock_s();
    return {{"frames", frames.ms.size()},
            {"frames_per_s", static_cast<double>(frames.ms.size()) / seconds},
            {"frame_ms", summary(frames)},
            {"kept_by_decisions_ms", summary(kept)},
            {"decisions_behind_ms", summary(behind)},
            {"taken_over_s", watch ? watch->taken() : Json::array()},
            {"refused", watch ? watch->refused() : Json::array()}};
}

}  // namespace cli
