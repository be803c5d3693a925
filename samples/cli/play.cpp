// claque play: pictures of the people in a file of trajectories, as they walked, or of the crowd in a record.
#include <cmath>

#include "samples/cli/command.h"
#include "samples/cli/progress.h"
#include "samples/cli/render_work.h"
#include "samples/cli/run_record.h"
#include "samples/cli/scene_about.h"
#include "samples/cli/track_arguments.h"
#include "samples/cli/work_share.h"
#include "samples/scenes/walkers/replay.h"
#ifdef CLAQUE_STAGED
#include "samples/stage/replayed_scene.h"
#endif

namespace cli
{
namespace
{

// The whole file, if neither a time nor frames are given.
void take_all_frames(RenderArguments &a, const TrackArguments &tracks)
{
    constexpr double most = 999999999;
    a.whole_path = false, a.list.clear();
    const ShownTimes times = times_of(tracks.file, reading_of(tracks));
    if (times.first_s * a.fps < 0 || times.last_s * a.fps > most)
        throw scenes::Failure(tracks.file + ": its clock runs from " + std::to_string(times.first_s) + " to " +
                              std::to_string(times.last_s) +
                              " s, for which there are no frame numbers: --time draws single pictures");
    a.range.first = static_cast<int>(std::ceil(times.first_s * a.fps));
    a.range.last = std::max(a.range.first, static_cast<int>(times.last_s * a.fps));
}

std::unique_ptr<scenes::Scene> make_replay(scenes::Library &library, const scenes::CrowdOptions &crowd_options,
                                           const scenes::walkers::ReplayOptions &replay,
                                           [[maybe_unused]] const scenes::Scenario *scenario)
{
#ifdef CLAQUE_STAGED
    if (scenario) return staged::make_replayed(library, crowd_options, *scenario, replay);
#endif
    return scenes::walkers::make_replay(library, crowd_options, replay);
}

// Reads the scenario of which the record is.
void take_scenario(SceneArguments &setup, bool is_record)
{
    if (setup.scenario.empty()) return;
    if (!is_record) throw CLI::ValidationError("--scenario", "is for records of its runs; FILE is no record");
    read_scenario(setup);
    if (!setup.described->stage)
        throw CLI::ValidationError("--scenario", setup.scenario + " has no [stage]: it has no runs");
    if (setup.camera.empty() && has_path(setup)) setup.camera = "path";  // as in the run
#ifndef CLAQUE_STAGED
    throw CLI::ValidationError("--scenario", "needs Recast, which this build has not");
#endif
}

// Of the scene that the options name, with its record.
auto scene_maker(const TrackArguments &tracks, const SceneArguments &setup,
                 const std::shared_ptr<std::unique_ptr<RunRecord>> &record)
{
    const scenes::walkers::Options options = walkers_of(tracks, setup.of_file.placement);
    const scenes::walkers::ReplayOptions replay = {tracks.file, options.characters, options.follow};
    return [options, replay, record, path = tracks.record, scenario = setup.described](
               scenes::Library &library, const scenes::CrowdOptions &crowd_options) {
        if (scenes::walkers::is_record(replay.file)) return make_replay(library, crowd_options, replay, scenario.get());
        Progress progress("claque");
        scenes::walkers::Options with_progress = options;
        with_progress.progress = [&](size_t done, size_t of) { progress.step(done, of); };
        scenes::CrowdOptions asked = crowd_options;
        if (!path.empty()) asked.as_shown = false;  // a record has all people, whatever was drawn
        std::unique_ptr<scenes::Scene> scene = scenes::walkers::make(library, asked, with_progress);
        if (!path.empty()) {
            *record = std::make_unique<RunRecord>(path);
            (*record)->begin(scene->crowd());
        }
        return scene;
    };
}

void take_camera(RenderArguments &a, const TrackArguments &tracks)
{
    if (!followed_by(tracks.camera).empty()) a.setup.camera = "overview";
    else a.setup.camera = tracks.camera;
}

}  // namespace

void add_play(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<RenderArguments>();
    auto tracks = std::make_shared<TrackArguments>();
    CLI::App *c =
        app.add_subcommand("play", "Draw people walking along the trajectories of a file, or the crowd of a record");
    c->add_option("FILE", tracks->file,
                  "Trajectories (docs/trajectories.md lists the formats), or a record (docs/records.md)")
        ->required();
    add_reading_options(*c, *tracks);
    add_walking_options(*c, *tracks);
    add_hide_option(*c, a->setup.of_file.placement);
    CLI::Option *clips = add_clip_files(*c, tracks->clips);
    c->get_option("--map")->needs(clips);
    add_placement_options(*c, a->setup.of_file.placement);
    add_picture_options(*c, a);
    c->remove_option(c->get_option("--camera"));
    c->add_option("--camera", tracks->camera,
                  "View of the people: overview, close, follow:ID over a person's shoulder, or path (with --path)")
        ->check(CLI::Validator(check_camera, ""))
        ->type_name("VIEW");
    c->get_option("--time")->description("Time of a single picture in seconds (default: all of FILE)")->default_str("");
    c->add_option("--record", tracks->record,
                  "Record what is drawn to this file, which `claque play` plays; draws finished frames again")
        ->check(CLI::Validator(check_record_name, ""))
        ->type_name("FILE.clt");
    c->add_option("--scenario", a->setup.scenario,
                  "The scenario of which FILE records a run: draws its stone, doors, light and cameras")
        ->type_name("SCENARIO.toml");
    c->callback([a, tracks, c, &chosen] {
        take_camera(*a, *tracks);
        const bool whole = a->frames == "all" || (a->frames.empty() && c->count("--time") == 0);
        if (whole && a->out != "-" && !is_frame_pattern(a->out))
            throw CLI::ValidationError("--out",
                                       "all of FILE is many pictures, which need one place for the frame number, as in "
                                       "frame-%05d.png; --time draws a single one");
        if (whole) a->frames = "0:1";  // the file says how many
        const bool played = scenes::walkers::is_record(tracks->file);
        if (played) refuse_reading_options(*c);
        take_scenario(a->setup, played);
        // A scene of people that it does not know has no shadows to paint.
        if (played && !is_theatre(a->setup) && a->setup.shadows == "painted") a->setup.shadows = "blob";
        if (!tracks->record.empty()) a->again = true;
        if (!tracks->record.empty() && process_count(a->processes) > 1)
            throw CLI::ValidationError("--record", "needs one process, which sees all of the crowd's calls");
        const auto record = std::make_shared<std::unique_ptr<RunRecord>>();
        a->setup.make = scene_maker(*tracks, a->setup, record);
        a->drawn = [record] {
            if (*record) (void)(*record)->end();
        };
        check_picture_usage(*a);
        chosen = [a, tracks, whole, played, record] {
            if (whole) take_all_frames(*a, *tracks);
            if (!a->frames.empty() || !a->manifest.empty())
                a->setup.made_of = {{"file", played ? record_about(tracks->file) : file_about(tracks->file)},
                                    {"ground", file_about(tracks->area)},
                                    {"camera", tracks->camera},
                                    {"tracks", tracks_about(*tracks)}};
            try {
                render(*a);
            } catch (...) {
                if (*record) (*record)->forget_crowd();
                throw;
            }
        };
    });
}

}  // namespace cli
