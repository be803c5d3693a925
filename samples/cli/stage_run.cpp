#include <optional>

#include "samples/cli/colour_arguments.h"
#include "samples/cli/files.h"
#include "samples/cli/position_files.h"
#include "samples/cli/progress.h"
#include "samples/cli/run_record.h"
#include "samples/cli/stage_work.h"
#include "samples/cli/stopwatch.h"
#include "samples/io/png.h"
#include "samples/stage/staged_scene.h"

namespace cli
{
namespace
{

void write_picture(const StageArguments &a, scenes::SceneRenderer &renderer, int frame)
{
    renderer.draw_frame();
    const std::vector<uint8_t> &rgb = renderer.read();
    const std::vector<unsigned char> file =
        io::png(rgb.data(), a.setup.width, a.setup.height, {{"Software", "claque " + version()}});
    write_whole(frame_path(a.out, frame), file.data(), file.size());
}

bool is_drawn(const StageArguments &a, int frame)
{
    return !a.frames.empty() && frame >= a.range.first && frame <= a.range.last &&
           (frame - a.range.first) % a.range.stride == 0;
}

// The frame of the time that is shown.
int frame_of(const StageArguments &a, staged::StagedScene &scene)
{
    return std::max(0, static_cast<int>(scene.run().shown_s() * a.fps + 0.5));
}

Json report_of(const StageArguments &a, staged::Run &run, int frames)
{
    const clq_stage_info info = run.info();
    const staged::RunCounts counts = run.counts();
    uint64_t done = 0, late = 0;
    double wait_s = 0;
    for (const clq_stage_class_info &one : info.classes) {
        done += one.done, late += one.late;
        wait_s = std::max(wait_s, one.longest_wait_s);
    }
    return {{"claque", version()},
            {"scenario", a.setup.scenario},
            {"seed", a.setup.seed},
            {"seconds", a.seconds},
            {"frames", frames},
            {"threads", thread_count(a.setup)},
            {"flows", a.in_turn ? "in turn" : "apart"},
            {"people", run.people().all().size()},
            {"came", counts.came},
            {"left", counts.left},
            {"decided_s", info.decided_s},
            {"ticks", info.ticks},
            {"decisions", done},
            {"late_decisions", late},
            {"longest_wait_s", wait_s},
            {"transitions", info.transitions},
            {"events", info.events},
            {"runaways", info.runaways},
            {"late_messages", info.late_messages},
            {"commands", counts.commands},
            {"late_commands", counts.late},
            {"refused_commands", counts.refused},
            {"hash", hex(info.hash)}};
}

void show_frame(const StageArguments &a, OpenRun &run, int frame)
{
    constexpr int frames_between_releases = 250;
    const double time_s = frame / a.fps;
    if (is_drawn(a, frame)) {
        run.renderer->update(time_s);
        write_picture(a, *run.renderer, frame);
    } else {
        run.scene->place(time_s);
        scenes::check(clq_crowd_update(run.scene->crowd(), time_s, nullptr, 0));
    }
    if (frame % frames_between_releases == 0) scenes::check(clq_crowd_release_tracks(run.scene->crowd(), nullptr));
}

// Obeys the next command before a frame is shown. Returns the last frame that is to be shown without asking again.
int obey(const StageArguments &a, OpenRun &run, const std::optional<StageCommand> &command, int &frame, int last)
{
    using Kind = StageCommand::Kind;
    const Kind kind = command ? command->kind : Kind::go;
    if (kind == Kind::step) return static_cast<int>(std::min<double>(last, frame - 1 + command->number));
    if (kind == Kind::to) return static_cast<int>(std::min<double>(last, command->number * a.fps + 1e-9));
    if (kind == Kind::go) return last;
    if (kind == Kind::save) save_to(command->text, *run.scene);
    if (kind == Kind::restore) restore_from(command->text, *run.scene), frame = frame_of(a, *run.scene);
    if (kind == Kind::send) run.scene->run().send_all(command->text, command->number);
    return frame - 1;
}

// All frames from one on. Returns their number.
int show_all(const StageArguments &a, OpenRun &run, int first, Progress &progress, StageCommands *commands)
{
    const int last = static_cast<int>(a.seconds * a.fps + 1e-9);
    const int saved = a.at_s < 0 ? last : static_cast<int>(a.at_s * a.fps + 1e-9);
    int shown = 0;
    for (int frame = first, goal = commands ? first - 1 : last; frame <= last;) {
        if (frame > goal) {
            const std::optional<StageCommand> command = commands->wait();
            if (command && command->kind == StageCommand::Kind::end) break;
            goal = obey(a, run, command, frame, last);
            continue;
        }
        show_frame(a, run, frame);
        if (!a.save.empty() && frame == saved) save_to(a.save, *run.scene);
        ++shown, ++frame;
        progress.step(static_cast<size_t>(frame - first), static_cast<size_t>(std::max(last, frame) + 1 - first));
    }
    return shown;
}

// As `claque tracks` measures the record.
Json measure_record(scenes::Library &library, const StageArguments &a, Progress &progress)
{
    constexpr double fastest_m_s = 12;
    progress.phase("measuring");
    const auto positions = scenes::walkers::positions_in(library, a.record, {}, a.fps,
                                                         [&](size_t done, size_t of) { progress.step(done, of); });
    const auto trajectories = trajectories_of(library, positions, a.record, fastest_m_s);
    const Measures measures = write_measures(library, a.measures, trajectories.get(), a.setup.scenario);
    if (a.json != "-" && !is_printed(a.measures)) std::fputs(told(measures).c_str(), stdout);
    return json_of(measures);
}

}  // namespace

void restore_from(const std::string &file, staged::StagedScene &scene)
{
    scenes::asked_at(file, [&] { scene.restore(read_file(file)); });
}

void save_to(const std::string &file, staged::StagedScene &scene)
{
    const std::vector<uint8_t> bytes = scene.save();
    write_whole(file, bytes.data(), bytes.size());
}

staged::StageOptions stage_options(const StageArguments &a)
{
    staged::StageOptions stage;
    stage.apart = !a.in_turn;
    stage.run.live = a.live;
    stage.run.stall_s = a.stall_ms / 1000;
    return stage;
}

OpenRun::OpenRun(scenes::Library &library, const StageArguments &a) { open(library, a, nullptr); }

OpenRun::OpenRun(scenes::Library &library, const StageArguments &a, std::unique_ptr<staged::StagedScene> made)
{
    open(library, a, std::move(made));
}

void OpenRun::open(scenes::Library &library, const StageArguments &a, std::unique_ptr<staged::StagedScene> made)
{
    LoadedCharacter loaded;
    scenes::SceneOptions options = scene_options(a.setup, loaded);
    options.make = [&](scenes::Library &with, const scenes::CrowdOptions &crowd_options) {
        if (!made) made = staged::make_staged(with, crowd_options, *a.setup.described, stage_options(a));
        scene = made.get();
        return std::unique_ptr<scenes::Scene>(std::move(made));
    };
    wear_colours(options, a.setup.colours.empty() ? a.setup.described->colours : a.setup.colours);
    if (a.frames.empty() && !a.draw) {
        own = options.make(library, options.crowd_options);
        return;
    }
    if (!a.setup.described->theatre) options.shadows.form = scenes::ShadowChoice::Form::blob;
    renderer.emplace(library, options);
}

void OpenRun::show(double time_s)
{
    if (renderer) {
        renderer->frame(time_s);
        return;
    }
    scene->place(time_s);
    scenes::check(clq_crowd_update(scene->crowd(), time_s, nullptr, 0));
}

void run_stage(const StageArguments &a)
{
    Progress progress("claque");
    for (const std::string &path : {a.record, a.json, a.save, a.out.empty() ? "" : frame_path(a.out, 0)})
        if (!path.empty()) expect_writable(path);
    if (!a.restore.empty()) expect_readable(a.restore);
    progress.phase("preparing");
    scenes::Library library(thread_count(a.setup));
    auto open = std::make_unique<OpenRun>(library, a);
    std::optional<RunRecord> record;
    std::optional<StageCommands> commands;
    if (!a.commands.empty()) commands.emplace(a.commands);
    if (!a.restore.empty()) restore_from(a.restore, *open->scene);
    const int first = a.restore.empty() ? 0 : frame_of(a, *open->scene);
    if (!a.record.empty()) record.emplace(a.record), record->begin(open->scene->crowd());
    Json times;
    int frames = 0;
    if (a.live)
        times = show_live(library, a, open, !record, commands ? &*commands : nullptr),
        frames = times["frames"].get<int>();
    else frames = show_all(a, *open, first, progress, commands ? &*commands : nullptr);
    open->scene->rest();
    Json report = report_of(a, open->scene->run(), frames);
    if (record) {
        const clq_recording_info info = record->end();
        report["record"] = {{"file", a.record},
                            {"bytes", info.bytes},
                            {"calls", info.calls},
                            {"steps", info.steps},
                            {"pieces", info.tracks}};
    }
    report["doors"] = Json::array();
    for (const staged::DoorCount &door : open->scene->run().doors()) {
        report["doors"].push_back({{"name", door.name},
                                   {"width_m", door.width_m},
                                   {"passed", door.passed_s.size()},
                                   {"people_per_s_m", staged::flow_of(door.passed_s, door.width_m)}});
        if (door.passed_s.empty()) continue;
        report["doors"].back()["first_s"] = door.passed_s.front();
        report["doors"].back()["last_s"] = door.passed_s.back();
    }
    if (a.live) report["live"] = times;
    if (measures_any(a.measures)) report["measures"] = measure_record(library, a, progress);
    report["warnings"] = library.warnings();
    if (!a.json.empty()) write_whole(a.json, report.dump(2) + "\n");
    progress.conclude(a.setup.scenario + ": " + report["came"].dump() + " people came, " + report["left"].dump() +
                      " left; " + report["frames"].dump() + " frames, " + report["decisions"].dump() + " decisions");
}

}  // namespace cli
