// claque bench: what a frame costs, by cache and by variety, in one run. A picture's hash stands beside every time:
// they have to be equal where the same is drawn, or the times mean nothing.
#include "samples/cli/bench.h"

#include "samples/cli/command.h"
#include "samples/cli/files.h"

#include <iostream>
#include <memory>

namespace cli
{

void expect_same_picture(std::string &before, const std::string &now, const std::string &what)
{
    if (before.empty()) before = now;
    if (now != before)
        throw scenes::Failure("the picture of " + what + " differs (" + now + ", not " + before +
                              "), so the times mean nothing");
}

namespace
{

bool of_actors(const BenchArguments &a)
{
    for (const scenes::SceneEntry &entry : scenes::scene_entries())
        if (a.setup.scene == entry.name) return entry.actors;
    return false;
}

bool is_growth(const BenchArguments &a) { return a.subject == "growth"; }
bool is_vertex_format(const BenchArguments &a) { return a.subject == "vertex_format"; }
bool is_of_shadows(const BenchArguments &a) { return !a.shadows.empty(); }
bool has_no_scene(const BenchArguments &a) { return is_growth(a) || is_vertex_format(a) || is_of_key_poses(a); }

void bench(const BenchArguments &a)
{
    for (const std::string &path : {a.save, a.operations})
        if (!path.empty()) expect_writable(path);
    const bool along_path = a.setup.camera == "path";
    const Json report = is_growth(a)          ? bench_growth(a)
                        : is_vertex_format(a) ? bench_vertex_format(a)
                        : is_of_key_poses(a)  ? bench_key_poses(a)
                        : is_of_shadows(a)    ? bench_shadows(a)
                        : along_path          ? bench_along_path(a)
                        : of_actors(a)        ? bench_actors(a)
                                              : bench_by_count(a);
    if (!a.operations.empty()) write_operations(a);
    if (!a.save.empty()) write_whole(a.save, report.dump(2) + "\n");
    if (a.json) std::cout << report.dump(2) << "\n";
    else if (a.markdown) std::cout << (is_of_key_poses(a) ? markdown_of_key_poses(report) : markdown_of(report));
    else if (is_growth(a)) print_growth(report);
    else if (is_vertex_format(a)) print_vertex_format(report);
    else if (is_of_key_poses(a)) print_key_poses(report);
    else if (is_of_shadows(a)) print_shadows(report);
    else if (along_path) print_sections(report);
    else if (of_actors(a)) print_actors(report);
    else print_counts(report);
}

void choose_scene(BenchArguments &a)
{
    if (has_no_scene(a)) return;
    a.setup.file = a.subject;
    for (const scenes::SceneEntry &entry : scenes::scene_entries())
        if (a.subject == entry.name) {
            a.setup.scene = a.subject;
            a.setup.file.clear();
        }
    if (a.setup.camera.empty()) a.setup.camera = has_path(a.setup) ? "path" : "overview";
    check_scene_usage(a.setup);
}

// What is not given is as a host would have it who wants ten thousand people fast: on a GL that rasterises while more is sent,
// where there is one (a flush of OSMesa's copies the picture), everybody cached and in one draw or fewer.
void prefer_speed(const CLI::App &command, BenchArguments &a)
{
    if (command.count("--cache") == 0) a.caches = {"full"};
    if (command.count("--strategy") == 0) a.strategies = {"fused"};
    if (command.count("--context") != 0) return;
    std::string why_not;
    if (!contexts::make_offscreen(contexts::Kind::egl, 16, 16, contexts::PixelFormat::rgba8888, why_not)) return;
    a.setup.context = "egl";
    if (command.count("--flush") == 0) a.setup.flush_triangles = 16384;
}

}  // namespace

void add_bench(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<BenchArguments>();
    CLI::App *c = app.add_subcommand(
        "bench", "Measure update and draw by cache and strategy, along a camera path or by number of people");
    c->add_option("SCENE", a->subject,
                  "A scene's name (ten_thousand: with --cache full --strategy fused, and on EGL --flush 16384, unless "
                  "said otherwise), or a character's file, or growth: updates of 1000 to 100 000 actors; "
                  "or vertex_format: packed vertices against floats; "
                  "or of shared key-poses (S3): keypose-choice, keypose-path, keypose-script, keypose-error")
        ->required();
    CLI::Option *count = c->add_option("--count", a->counts, "Numbers of people, with commas; along a path one at most")
                             ->delimiter(',')
                             ->check(CLI::Range(1, 1000000))
                             ->capture_default_str();
    c->add_option("--strategy", a->strategies, "Which, with commas")
        ->delimiter(',')
        ->check(CLI::IsMember(strategy_names()))
        ->capture_default_str();
    c->add_option("--cache", a->caches,
                  "Which, with commas; those of key-poses (S3) may have a size, as keypose-intermittent:100")
        ->delimiter(',')
        ->check(cache_choice)
        ->capture_default_str();
    c->add_option("--lod", a->lods,
                  "Along the path of the odeon: people with levels of detail, or without, or both with a comma (S1 "
                  "Fig. 8); with "
                  "--shadows one of them")
        ->delimiter(',')
        ->check(CLI::IsMember({"off", "on"}))
        ->capture_default_str();
    c->add_option(
         "--shadows", a->shadows,
         "What shadows on the ground cost, by kind, with commas, instead of caches and varieties: none, blob, mesh, "
         "and with a stencil bit lent blob-stencil, mesh-stencil")
        ->delimiter(',')
        ->check(CLI::IsMember(shadow_names()));
    c->add_option("--frames", a->frames, "Measured frames a run, or a section of the path, at 25 a second")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    CLI::Option *cull = c->add_option("--cull", a->culls, "Of scenes of actors: which modes, with commas")
                            ->delimiter(',')
                            ->check(CLI::IsMember({"actor", "traditional"}))
                            ->capture_default_str();
    c->add_option("--operations", a->operations,
                  "Of a scene of actors: also write how often each operation of S0's Table 1 was done, for claque cost "
                  "--measured")
        ->type_name("FILE");
    add_scene_options(*c, a->setup);
    CLI::Option *json = c->add_flag("--json", a->json, "As JSON instead of a table (claque plot draws it)");
    c->add_flag("--markdown", a->markdown, "Along a path, or of shared key-poses: as a table for a README")
        ->excludes(json);
    c->add_option("--save", a->save, "Write the JSON here as well")->excludes(json);
    c->callback([a, c, count, cull, &chosen] {
        choose_scene(*a);
        if (cull->count() > 0 && !of_actors(*a))
            throw CLI::ValidationError("--cull",
                                       "compares modes on scenes of actors: hundred_actors, town_sky, vehicle");
        if (a->lods != std::vector<std::string>{"off"} && !is_of_shadows(*a) &&
            (a->setup.camera != "path" || scene_of(a->setup) != "odeon"))
            throw CLI::ValidationError("--lod", "is for the odeon along its path");
        if (a->subject == "ten_thousand" && count->count() == 0) a->counts = {100, 1000, 10000, 20000};
        if (a->subject == "ten_thousand" && !is_of_shadows(*a)) prefer_speed(*c, *a);
        if (is_growth(*a) && count->count() == 0) a->counts = {1000, 3000, 10000, 30000, 100000};
        if (is_of_key_poses(*a) && count->count() == 0) a->counts = {a->subject == "keypose-script" ? 2500u : 10000u};
        if (of_actors(*a) && count->count() == 0)
            for (const scenes::SceneEntry &entry : scenes::scene_entries())
                if (a->setup.scene == entry.name) a->counts = {entry.default_count};
        if (is_of_shadows(*a) && (has_no_scene(*a) || of_actors(*a) || !a->operations.empty()))
            throw CLI::ValidationError("--shadows",
                                       "is for scenes with a ground: plaza, multitude, ten_thousand, parade");
        if (!a->operations.empty() && (!of_actors(*a) || a->counts.size() > 1))
            throw CLI::ValidationError("--operations",
                                       "is for one scene of actors, of one number: hundred_actors, town_sky, vehicle");
        if (a->setup.camera != "path" && !is_of_key_poses(*a) && a->markdown)
            throw CLI::ValidationError("--markdown", "is for cameras that follow a path, and for key-poses");
        if (a->setup.camera == "path" && count->count() > 0) {
            if (a->counts.size() > 1)
                throw CLI::ValidationError("--count", "along a path there is one crowd, and so one number at most");
            a->setup.count = a->counts[0];
        }
        chosen = [a] { bench(*a); };
    });
}

}  // namespace cli
