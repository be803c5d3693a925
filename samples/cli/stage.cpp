// claque stage: runs a scenario whose people decide, and records it or draws it.
#include <cmath>

#include "samples/cli/command.h"
#include "samples/cli/run_record.h"
#include "samples/cli/stage_work.h"

namespace cli
{
namespace
{

void add_outputs(CLI::App &c, const std::shared_ptr<StageArguments> &a)
{
    c.add_option("--record", a->record, "Write the run to this file, which `claque play` shows")
        ->check(CLI::Validator(check_record_name, ""))
        ->type_name("FILE.clt");
    add_measure_options(c, a->measures);
    c.get_option("--measure")->needs(c.get_option("--record"));
    CLI::Option *frames =
        c.add_option("--frames", a->frames, "Draw these frames, first to last; frame k shows k / fps seconds")
            ->type_name("A:B");
    CLI::Option *out = c.add_option("--out,-o", a->out, "PNG files: a pattern like f-%05d.png");
    frames->needs(out), out->needs(frames);
    c.add_option("--stride", a->range.stride, "Draw only every N-th frame")
        ->check(CLI::Range(1, 1000000))
        ->needs(frames);
    c.add_option("--restore", a->restore, "Go on from a state that --save wrote, of the same scenario and seed")
        ->type_name("FILE");
    CLI::Option *save = c.add_option("--save", a->save, "Write the state of the run, for --restore")->type_name("FILE");
    c.add_option("--at", a->at_s, "Seconds at which --save writes it (default: at the end)")
        ->check(CLI::Range(0.0, 86400.0))
        ->needs(save);
    c.add_option("--commands", a->commands,
                 "Obey the lines of this file while the run goes: step, to, go, pause, save, restore, send, end "
                 "(docs/stage.md); - is standard input")
        ->type_name("FILE");
    c.add_option("--json", a->json, "Write what was decided and shown as JSON; - is standard output");
}

void check_usage(StageArguments &a)
{
    check_measures(a.measures, {a.json});
    read_scenario(a.setup);
    check_scene_usage(a.setup);
    if (!a.setup.described->stage)
        throw CLI::ValidationError("SCENARIO", a.setup.scenario + " has no [stage]: its people do not decide");
    if (!a.frames.empty()) {
        if (a.setup.camera.empty() && has_path(a.setup)) a.setup.camera = "path";
        const std::string wrong = read_range(a.frames, a.range);
        if (!wrong.empty()) throw CLI::ValidationError("--frames", wrong);
        if (!is_frame_pattern(a.out))
            throw CLI::ValidationError("--out", "needs one place for the frame number, as in frame-%05d.png");
    }
    if (!(a.fps > 0 && a.fps <= 1000)) throw CLI::ValidationError("--fps", "must be above 0, and 1000 at most");
    if (a.seconds == 0) a.seconds = a.setup.described->stage->seconds;
    if (!(a.seconds > 0 && a.seconds <= 86400))
        throw CLI::ValidationError("--seconds", "must be above 0, and 86400 at most");
    if (a.at_s > a.seconds)
        throw CLI::ValidationError("--at", "is after the end of the run, at " + std::to_string(a.seconds) + " s");
    if (!a.frames.empty() && a.range.last > a.seconds * a.fps)
        throw CLI::ValidationError("--frames", "ends at " + std::to_string(a.range.last) + ", and the run has " +
                                                   std::to_string(static_cast<int>(a.seconds * a.fps)) + " frames");
}

}  // namespace

void add_stage(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<StageArguments>();
    CLI::App *c = app.add_subcommand("stage", "Run a scenario whose people decide: record it, draw it, measure it");
    c->add_option("SCENARIO", a->setup.scenario, "A scenario with [stage] (TOML, docs/scenarios.md)")->required();
    add_scene_options(*c, a->setup);
    add_hide_option(*c, a->setup.of_file.placement);
    add_placement_options(*c, a->setup.of_file.placement);
    add_outputs(*c, a);
    c->add_option("--seconds", a->seconds, "Length of the run (default: as the scenario says)");
    c->add_option("--fps", a->fps, "Frames a second of the run: of its record and of its pictures")
        ->capture_default_str();
    CLI::Option *apart = c->add_flag("--apart", a->apart, "Decisions in a thread of their own (default)");
    c->add_flag("--in-turn", a->in_turn, "Decisions and drawing in turn on one thread; the record is the same")
        ->excludes(apart);
    CLI::Option *live = c->add_flag("--live", a->live,
                                    "Run at the pace of the clock, with a budget in microseconds; a scenario that "
                                    "changes meanwhile is taken over, unless it is recorded");
    for (const char *of_all_frames : {"--frames", "--save"}) live->excludes(c->get_option(of_all_frames));
    c->add_flag("--draw", a->draw, "Draw each frame without keeping the picture, for measuring")->needs(live);
    c->add_option("--stall", a->stall_ms, "For measuring: a decision that takes so many milliseconds, every 5 s")
        ->check(CLI::Range(0.0, 10000.0));
    c->callback([a, &chosen] {
        check_usage(*a);
        chosen = [a] { run_stage(*a); };
    });
}

}  // namespace cli
