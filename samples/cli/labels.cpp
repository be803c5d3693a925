// claque labels: pictures with exact labels, for training and testing what looks at pictures.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "samples/cli/command.h"
#include "samples/cli/label_work.h"
#include "samples/cli/sequence.h"
#include "samples/cli/work_share.h"
#include "samples/io/joined.h"
#include "samples/labels/formats.h"
#include "samples/scenes/walkers/replay.h"

namespace cli
{
namespace
{

// As `play` shows it.
void choose_record(const CLI::App &command, LabelArguments &a)
{
    refuse_reading_options(command);
    const scenes::walkers::ReplayOptions replay = {
        a.tracks.file, walkers_of(a.tracks, a.setup.of_file.placement).characters, followed_by(a.setup.camera)};
    if (!replay.follow.empty()) a.tracks.camera = a.setup.camera, a.setup.camera = "overview";
    if (a.setup.shadows == "painted") a.setup.shadows = "blob";  // painted shadows need people known in advance
    a.setup.make = [replay](scenes::Library &library, const scenes::CrowdOptions &crowd_options) {
        return scenes::walkers::make_replay(library, crowd_options, replay);
    };
}

// WHAT is the name of a scene, a scenario, a file of trajectories, or a record.
void choose_subject(const CLI::App &command, const std::string &subject, LabelArguments &a)
{
    namespace fs = std::filesystem;
    const bool is_scene = !subject.empty() && scene_names()(subject).empty();
    const bool is_scenario = !is_scene && fs::path(subject).extension() == ".toml";
    if (is_scene) a.setup.scene = subject;
    if (is_scenario) a.setup.scenario = subject;
    const bool walks = !subject.empty() && !is_scene && !is_scenario;
    if (walks && !names_trajectories(subject))
        throw CLI::ValidationError(
            "WHAT", fs::is_regular_file(subject)
                        ? subject +
                              " is a character; labels are of scenes, scenarios (TOML), "
                              "files of trajectories and records"
                        : subject + " is no scene, and no file of that name exists; scenes are " + list_of_scenes());
    if (!walks) refuse_track_options(command);
    read_scenario(a.setup);
    if (walks) a.tracks.file = subject;
    if (walks && scenes::walkers::is_record(subject)) choose_record(command, a);
    else if (walks) a.setup.described = scenario_of(a.tracks, a.setup.of_file.placement);
    check_scene_usage(a.setup);
}

// Frames behind the end of a file would show nobody. Where rules choose the time, frames are numbers of samples.
void expect_frames(const LabelArguments &a)
{
    const auto &tracks = a.setup.described ? a.setup.described->tracks : std::nullopt;
    if ((!tracks && !a.setup.make) || (a.rules && a.rules->time_s)) return;
    constexpr double instant_s = 1e-6;
    const std::string file = tracks ? tracks->path : a.tracks.file;
    clq_trajectories_def reading = tracks ? tracks->reading : clq_trajectories_def_init();
    if (tracks && !tracks->columns.empty()) reading.columns = tracks->columns.c_str();
    const ShownTimes times = scenes::asked_at(tracks ? tracks->at : "", [&] { return times_of(file, reading); });
    const int last = *std::max_element(a.list.begin(), a.list.end());
    const double end = (times.last_s + instant_s) * a.fps;
    if (last <= end) return;
    char text[80];
    std::snprintf(text, sizeof text, " is %.0f at %g frames a second", std::floor(end), a.fps);
    throw CLI::ValidationError("--frames",
                               "ends at " + std::to_string(last) + ", and the last frame of " + file + text);
}

}  // namespace

void add_labels(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<LabelArguments>();
    const auto frames = std::make_shared<std::string>("0"), write = std::make_shared<std::string>("coco");
    const auto subject = std::make_shared<std::string>();
    CLI::App *c = app.add_subcommand(
        "labels", "Pictures with exact labels: what every pixel is, where it moves, and where people's joints are");
    CLI::Option *what =
        c->add_option(
             "what", *subject,
             "A scene, a scenario (TOML), a file of trajectories (docs/trajectories.md) or a record (docs/records.md)")
            ->type_name("SCENE|SCENARIO|TRACKS|RECORD");
    c->add_option("--scene", a->setup.scene, "A scene of built-in characters (default plaza)")
        ->check(scene_names())
        ->excludes(what);
    add_scenario_option(*c, a->setup)->excludes(c->get_option("--scene"))->excludes(what);
    c->add_option("--count", a->setup.count, "Individuals (default: the scene's own number)")
        ->check(CLI::Range(1, 1000000));
    add_scene_options(*c, a->setup);
    add_reading_options(*c, a->tracks);
    add_walking_options(*c, a->tracks);
    add_hide_option(*c, a->setup.of_file.placement);
    add_placement_options(*c, a->setup.of_file.placement);
    c->add_option("--lod", a->setup.lod, "People with levels of detail (on) or without (off)")
        ->check(CLI::IsMember({"off", "on", "finest"}))
        ->capture_default_str();
    c->add_option("--frames", *frames, "First to last, single frames and strides, as in 0:99,120,200:240/4")
        ->type_name("LIST")
        ->capture_default_str();
    c->add_option("--vary", a->vary,
                  "Rules by which each picture is another sample: cameras, people, light, haze and sensors (TOML, "
                  "docs/labels.md). Frame k is sample k, a function of the rules, --seed and k")
        ->type_name("RULES");
    c->add_option("--fps", a->fps, "Frames a second: frame k shows k / fps seconds, and flow reaches one frame")
        ->capture_default_str();
    c->add_option("--write", *write, "Formats, separated by commas: " + io::joined(labels::format_names()))
        ->capture_default_str();
    c->add_option("--keypoints", a->keypoints, "coco (17 joints), smpl (24), or a file of your own (TOML)")
        ->type_name("NAME|FILE")
        ->capture_default_str();
    c->add_option_function<std::string>(
         "--chunk",
         [a](const std::string &text) {
             const std::string wrong = read_share(text, a->chunk, a->chunk_count);
             if (!wrong.empty()) throw CLI::ValidationError("--chunk", wrong);
         },
         "Only share K of N of the pictures, from 0/N to N-1/N: one job of an array. A run without it makes the files "
         "about all pictures")
        ->type_name("K/N");
    c->add_option(
         "--processes", a->processes,
         "Label by this many processes, each of which makes whole pictures; no file depends on it (default: 1; "
         "in a job of a scheduler the cores that it got)")
        ->check(CLI::Range(1, 256));
    c->add_flag("--again", a->again, "Label finished pictures again");
    c->add_flag("--portable", a->portable,
                "Restrict Mesa to what every x86-64 processor can do, so that all of them draw the same pixels");
    c->add_option("--out,-o", a->out, "Folder; pictures that it has already are kept")->required();
    c->add_option("--json", a->json, "Write times as JSON; - is standard output");
    c->callback([a, c, subject, frames, write, &chosen] {
        check_process_usage(a->processes);
        choose_subject(*c, *subject, *a);
        a->keypoint_set = labels::keypoint_set(a->keypoints);
        if (!a->vary.empty()) a->rules = labels::load_rules(a->vary);
        const bool is_ruled = a->rules && a->rules->camera;
        if (a->setup.camera.empty() && has_path(a->setup) && !is_ruled) a->setup.camera = "path";
        const std::string wrong = read_frames(*frames, a->list);
        if (!wrong.empty()) throw CLI::ValidationError("--frames", wrong);
        if (!(a->fps > 0 && a->fps <= 1e6)) throw CLI::ValidationError("--fps", "must be above 0");
        try {
            a->formats = labels::read_formats(*write);
        } catch (const scenes::Failure &failure) {
            throw CLI::ValidationError("--write", failure.what());
        }
        if (a->rules && a->formats.count("mot") != 0)
            throw CLI::ValidationError("--write", "mot is about the frames of a film, and --vary makes samples");
        chosen = [a] {
            expect_frames(*a);
            label(*a);
        };
    });
}

}  // namespace cli
