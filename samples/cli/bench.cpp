// claque bench: what a frame costs, by cache and by draw strategy, in one run. Every time has the hash of its picture
// beside it: where the same is drawn the hashes must be equal, or the times cannot be compared.
#include "samples/cli/bench.h"

#include <iostream>
#include <memory>

#include "lib/base/near_names.h"
#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/stopwatch.h"
#include "samples/cli/track_arguments.h"

namespace cli
{

void expect_same_picture(std::string &before, const std::string &now, const std::string &what)
{
    if (before.empty()) before = now;
    if (now != before)
        throw scenes::Failure("the picture of " + what + " is " + now + ", not " + before +
                              ", so the times mean nothing");
}

namespace
{

bool of_actors(const BenchArguments &a)
{
    for (const scenes::SceneEntry &entry : scenes::scene_entries())
        if (a.setup.scene == entry.name) return entry.actors;
    return false;
}

bool is_of_halls(const BenchArguments &a) { return a.subject == "doors" || a.subject == "walking"; }
bool is_growth(const BenchArguments &a) { return a.subject == "growth"; }
bool is_vertex_format(const BenchArguments &a) { return a.subject == "vertex_format"; }
bool is_of_close_textures(const BenchArguments &a) { return a.subject == "close_textures"; }
bool is_of_shadows(const BenchArguments &a) { return !a.shadows.empty(); }
bool is_of_processes(const BenchArguments &a) { return !a.processes.empty(); }
bool has_no_scene(const BenchArguments &a)
{
    return is_growth(a) || is_vertex_format(a) || is_of_close_textures(a) || is_of_flicker(a) || is_of_key_poses(a) ||
           is_of_readers(a) || is_of_tracks(a) || is_of_cities(a) || is_of_halls(a);
}

void bench(const BenchArguments &a)
{
    for (const std::string &path : {a.save, a.operations})
        if (!path.empty()) expect_writable(path);
    const bool along_path = a.setup.camera == "path";
    const bool of_processors = a.clock == "processor";
    Stopwatch::use(of_processors ? Stopwatch::Clock::processor : Stopwatch::Clock::wall);
    Json report = is_growth(a)              ? bench_growth(a)
                  : is_of_close_textures(a) ? bench_close_textures(a)
                  : is_vertex_format(a)     ? bench_vertex_format(a)
                  : is_of_flicker(a)        ? bench_flicker(a)
                  : is_of_key_poses(a)      ? bench_key_poses(a)
                  : is_of_readers(a)        ? bench_readers(a)
                  : is_of_tracks(a)         ? bench_tracks(a)
                  : is_of_cities(a)         ? bench_cities(a)
                  : is_of_halls(a)          ? bench_halls(a)
                  : is_of_shadows(a)        ? bench_shadows(a)
                  : is_of_processes(a)      ? bench_processes(a)
                  : along_path              ? bench_along_path(a)
                  : of_actors(a)            ? bench_actors(a)
                                            : bench_by_count(a);
    report["clock"] = a.clock;
    if (!a.operations.empty()) write_operations(a);
    if (!a.save.empty()) write_whole(a.save, report.dump(2) + "\n");
    if (a.json) std::cout << report.dump(2) << "\n";
    else if (a.markdown) std::cout << (is_of_key_poses(a) ? markdown_of_key_poses(report) : markdown_of(report));
    else if (is_growth(a)) print_growth(report);
    else if (is_of_close_textures(a)) print_close_textures(report);
    else if (is_vertex_format(a)) print_vertex_format(report);
    else if (is_of_flicker(a)) print_flicker(report);
    else if (is_of_key_poses(a)) print_key_poses(report);
    else if (is_of_readers(a)) print_readers(report);
    else if (is_of_tracks(a)) print_tracks(report);
    else if (is_of_cities(a)) print_cities(report);
    else if (is_of_halls(a)) print_halls(report);
    else if (is_of_shadows(a)) print_shadows(report);
    else if (is_of_processes(a)) print_processes(report);
    else if (along_path) print_sections(report);
    else if (of_actors(a)) print_actors(report);
    else print_counts(report);
    if (of_processors && !a.json) std::cout << "\nTimes are of the processors, all threads together.\n";
    if (is_of_readers(a)) readers::expect_lawful(report);
}

void add_law_options(CLI::App &command, BenchArguments &a)
{
    command
        .add_option("--most-ratio", a.reader_law.most_ratio,
                    "readers: the most times the time that ten times the elements may take, or the command ends with 1")
        ->check(CLI::Range(1e-6, 1e6))
        ->capture_default_str();
    command
        .add_option("--least-ms", a.reader_law.least_ms,
                    "readers: shorter times are not judged, in milliseconds of processor time")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
}

void refuse_law_options(const CLI::App &command)
{
    for (const char *option : {"--most-ratio", "--least-ms"})
        if (command.count(option) > 0) throw CLI::ValidationError(option, "judges readers alone");
}

// A subject with a letter too few is no character.
void expect_no_near_subject(const std::string &name)
{
    const std::vector<std::string> subjects = {
        "growth", "million", "million-memory", "vertex_format",  "flicker",      "close_textures", "readers",
        "tracks", "doors",   "walking",        "keypose-choice", "keypose-path", "keypose-script", "keypose-error"};
    const std::string near = claque::base::near_names(name, subjects);
    if (!near.empty()) throw CLI::ValidationError("SCENE", "'" + name + "' is nothing to measure: " + near);
}

void choose_scene(const CLI::App &command, BenchArguments &a, TrackArguments &tracks)
{
    expect_subject(a.subject, a.setup);
    const bool walks = names_trajectories(a.subject);
    if (!walks) refuse_track_options(command);
    if (!is_of_readers(a)) refuse_law_options(command);
    if (has_no_scene(a)) return;
    read_scenario(a.setup);
    if (walks) tracks.file = a.subject, a.setup.described = scenario_of(tracks, a.setup.of_file.placement);
    else a.setup.file = a.subject;
    for (const scenes::SceneEntry &entry : scenes::scene_entries())
        if (a.subject == entry.name) {
            a.setup.scene = a.subject;
            a.setup.file.clear();
        }
    if (!a.setup.file.empty() && !scenes::is_file(a.setup.file)) expect_no_near_subject(a.setup.file);
    if (a.setup.camera.empty() && has_path(a.setup)) a.setup.camera = "path";
    check_scene_usage(a.setup);
}

// Defaults for a host that draws ten thousand people fast: every individual cached, the fused strategy, and a GL that
// rasterises while triangles are still sent, where there is one (a flush of OSMesa copies the picture).
void prefer_speed(const CLI::App &command, BenchArguments &a)
{
    if (command.count("--cache") == 0) a.caches = {"full"};
    if (command.count("--strategy") == 0) a.strategies = {"fused"};
    // Processes are forked by one that has no GL.
    if (command.count("--context") != 0 || contexts::kind_of_environment() != contexts::Kind::any || is_of_processes(a))
        return;
    std::string why_not;
    if (!contexts::make_offscreen(contexts::Kind::egl, 16, 16, contexts::PixelFormat::rgba8888, why_not)) return;
    a.setup.context = "egl";
}

// The numbers of people where none are given.
void choose_counts(BenchArguments &a)
{
    if (a.setup.described) a.counts = {0};  // its own number
    if (a.subject == "ten_thousand") a.counts = {100, 1000, 10000, 20000};
    if (is_growth(a)) a.counts = {1000, 3000, 10000, 30000, 100000};
    if (is_of_close_textures(a)) a.counts = {1000};
    if (is_of_cities(a)) a.counts = {1000, 10000, 100000, 1000000};
    if (is_of_tracks(a)) a.counts = {1000, 10000};
    if (is_of_readers(a)) a.counts = {100000};
    if (is_of_key_poses(a)) a.counts = {a.subject == "keypose-script" ? 2500u : 10000u};
    if (!of_actors(a)) return;
    for (const scenes::SceneEntry &entry : scenes::scene_entries())
        if (a.setup.scene == entry.name) a.counts = {entry.default_count};
}

}  // namespace

void add_bench(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<BenchArguments>();
    auto tracks = std::make_shared<TrackArguments>();
    CLI::App *c = app.add_subcommand(
        "bench", "Measure update and draw by cache and strategy, along a camera path or by number of people");
    c->add_option(
        "SCENE", a->subject,
        "What to measure: the name of a scene (ten_thousand defaults to --cache full --strategy fused, on EGL if it is "
        "there); a character's file; a file of trajectories (docs/trajectories.md); growth: updates of 1000 to "
        "100 000 actors; million: a city of up to a million, million-memory: the same for a chart of its memory; "
        "vertex_format: packed vertices against floats; close_textures: a texture for each of 1000 people against one "
        "for all; flicker: how much the odeon flickers past a crowd that stands still; readers: how the time of "
        "reading grows with the counts in a file; tracks: people who walk on tracks against people in place; doors: "
        "walkers of claque-stage who leave halls; walking: walkers in corridors (docs/navigation.md); or shared "
        "key-poses (S3): keypose-choice, keypose-path, keypose-script, keypose-error");
    add_scenario_option(*c, a->setup);
    CLI::Option *count =
        c->add_option(
             "--count", a->counts,
             "Numbers of people, separated by commas; along a path at most one. readers: the most elements of a file")
            ->delimiter(',')
            ->check(CLI::Range(1, 1000000))
            ->capture_default_str();
    c->add_option("--strategy", a->strategies, "Draw strategies to compare, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(strategy_names()))
        ->capture_default_str();
    c->add_option(
         "--cache", a->caches,
         "Caches to compare, separated by commas; key-pose caches (S3) may name a size, as keypose-intermittent:100")
        ->delimiter(',')
        ->check(cache_choice)
        ->capture_default_str();
    CLI::Option *lod =
        c->add_option(
             "--lod", a->lods,
             "People with levels of detail (on) or without (off); along a theatre's path also both, separated by a "
             "comma (S1 Fig. 8)")
            ->delimiter(',')
            ->check(CLI::IsMember({"off", "on"}))
            ->capture_default_str();
    c->add_option("--shadows", a->shadows,
                  "Measure shadows on the ground instead of caches and strategies; kinds separated by commas: none, "
                  "blob, mesh, and with a stencil bit blob-stencil, mesh-stencil")
        ->delimiter(',')
        ->check(CLI::IsMember(shadow_names()));
    c->add_option(
         "--processes", a->processes,
         "Measure one picture in tiles by these numbers of processes, separated by commas (docs/films.md); with "
         "1 first also a model of more")
        ->delimiter(',')
        ->check(CLI::Range(1, 64));
    c->add_option("--clock", a->clock,
                  "What times are of: wall; or processor, of all threads and of GL's, which other programs change less")
        ->check(CLI::IsMember({"wall", "processor"}))
        ->capture_default_str();
    c->add_option("--frames", a->frames, "Measured frames of a run, or of each section of the path, at 25 a second")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    CLI::Option *cull =
        c->add_option("--cull", a->culls, "Cull modes to compare in a scene of actors, separated by commas")
            ->delimiter(',')
            ->check(CLI::IsMember({"actor", "traditional"}))
            ->capture_default_str();
    c->add_option("--operations", a->operations,
                  "For a scene of actors: also write how often each operation of S0's Table 1 was done, for claque "
                  "cost --measured")
        ->type_name("FILE");
    c->add_option("--seeds", a->seeds, "doors and walking: how many crowds each row has")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    add_law_options(*c, *a);
    add_reading_options(*c, *tracks);
    add_walking_options(*c, *tracks);
    add_file_options(*c, a->setup.of_file);
    add_scene_options(*c, a->setup);
    CLI::Option *json = c->add_flag("--json", a->json, "Print JSON instead of a table (claque plot draws it)");
    c->add_flag("--markdown", a->markdown, "Along a path, or for shared key-poses: print a Markdown table")
        ->excludes(json);
    c->add_option("--save", a->save, "Also write the JSON to this file")->excludes(json);
    c->callback([a, tracks, c, count, cull, lod, &chosen] {
        choose_scene(*c, *a, *tracks);
        if (cull->count() > 0 && !of_actors(*a))
            throw CLI::ValidationError("--cull",
                                       "compares cull modes in scenes of actors: hundred_actors, town_sky, vehicle");
        const bool of_odeon = is_of_flicker(*a);
        if (lod->count() > 0 && !of_odeon && (has_no_scene(*a) || of_actors(*a)))
            throw CLI::ValidationError("--lod", "needs a scene with people");
        if (a->lods.size() > 1 && !of_odeon &&
            (a->setup.camera != "path" || !is_theatre(a->setup) || is_of_shadows(*a)))
            throw CLI::ValidationError("--lod", "takes one value but in a theatre with a camera that follows a path");
        if (c->count("--seeds") > 0 && !is_of_halls(*a))
            throw CLI::ValidationError("--seeds", "is for doors and walking alone");
        if (c->count("--seed") > 0 && is_of_halls(*a))
            throw CLI::ValidationError("--seed", "changes no doors and no walking: --seeds N tries seeds 1 to N");
        a->setup.lod = a->lods.front();
        if (count->count() == 0) choose_counts(*a);
        else if (a->setup.described && a->setup.described->tracks)
            throw CLI::ValidationError("--count", "is that of the file of trajectories where people walk on tracks");
        if (a->subject == "ten_thousand" && !is_of_shadows(*a)) prefer_speed(*c, *a);
        if (is_of_shadows(*a) && (has_no_scene(*a) || of_actors(*a) || !a->operations.empty()))
            throw CLI::ValidationError("--shadows",
                                       "needs a scene with a ground: plaza, multitude, ten_thousand, parade");
        if (!a->operations.empty() && (!of_actors(*a) || a->counts.size() > 1))
            throw CLI::ValidationError(
                "--operations",
                "needs one scene of actors, with one number of people: hundred_actors, town_sky, vehicle");
        if (a->setup.camera != "path" && !is_of_key_poses(*a) && a->markdown)
            throw CLI::ValidationError("--markdown", "needs a camera that follows a path, or shared key-poses");
        if (a->setup.camera == "path" && count->count() > 0) {
            if (a->counts.size() > 1)
                throw CLI::ValidationError("--count",
                                           "takes at most one number along a path, where there is one crowd");
            a->setup.count = a->counts[0];
        }
        if (is_of_processes(*a) && (has_no_scene(*a) || is_of_shadows(*a) || !a->operations.empty() || a->markdown))
            throw CLI::ValidationError("--processes", "needs a scene, and compares numbers of processes alone");
        chosen = [a] { bench(*a); };
    });
}

}  // namespace cli
