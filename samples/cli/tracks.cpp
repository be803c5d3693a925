// claque tracks: contents and measures of a file of trajectories or a record, its people as claque shows them, a plan
// of the paths, and the positions in a record as a file for other programs.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "samples/cli/command.h"
#include "samples/cli/files.h"
#include "samples/cli/measure_arguments.h"
#include "samples/cli/plot.h"
#include "samples/cli/position_files.h"
#include "samples/cli/progress.h"
#include "samples/cli/track_arguments.h"
#include "samples/cli/tracks_report.h"
#include "samples/scenes/walkers/record_file.h"

namespace cli
{
namespace
{

using scenes::check;

// Speeds between the samples a quarter of a second before and after each, or the neighbours where they are farther.
std::vector<double> speeds_of(const clq_trajectories *trajectories, uint32_t person_count)
{
    const clq_trajectory_sample *all = clq_trajectories_get_samples(trajectories);
    std::vector<double> speeds;
    for (uint32_t p = 0; p < person_count; ++p) {
        clq_trajectory_person person = clq_trajectory_person_init();
        check(clq_trajectories_get_person(trajectories, p, &person));
        const clq_trajectory_sample *own = all + person.first_sample;
        const uint64_t count = own->flags == 0 ? person.sample_count : 0;  // of people on foot
        for (uint64_t i = 0, first = 0, last = 0; i < count && count > 1; ++i) {
            while (first < i && own[first].time_s < own[i].time_s - 0.25) ++first;
            while (last + 1 < count && own[last + 1].time_s <= own[i].time_s + 0.25) ++last;
            const uint64_t a = first < i ? first : i > 0 ? i - 1 : 0, b = last > i ? last : std::min(count - 1, i + 1);
            const double x = own[b].x - own[a].x, y = own[b].y - own[a].y;
            speeds.push_back(std::sqrt(x * x + y * y) / (own[b].time_s - own[a].time_s));
        }
    }
    std::sort(speeds.begin(), speeds.end());
    return speeds;
}

double at_share(const std::vector<double> &sorted, double share)
{
    return sorted.empty() ? 0 : sorted[std::min(sorted.size() - 1, size_t(share * double(sorted.size())))];
}

TracksReport report_of(const Tracks &tracks, const std::string &file)
{
    TracksReport r;
    r.file = file;
    const clq_trajectories *trajectories = tracks.trajectories.get();
    check(clq_trajectories_get_info(trajectories, &r.info));
    const std::vector<double> speeds = speeds_of(trajectories, r.info.person_count);
    r.median_m_s = at_share(speeds, 0.5), r.fast_m_s = at_share(speeds, 0.99);
    r.fastest_m_s = speeds.empty() ? 0 : speeds.back();
    r.slow_share = speeds.empty() ? 0
                                  : double(std::lower_bound(speeds.begin(), speeds.end(), 0.1) - speeds.begin()) /
                                        double(speeds.size());
    double seconds = 0, standing = 0;
    for (const scenes::walkers::Person &person : tracks.people) {
        r.vehicles += person.kind == scenes::walkers::Person::Kind::vehicle;
        r.riders += person.kind == scenes::walkers::Person::Kind::rides;
    }
    const double walkers = double(tracks.people.size() - r.vehicles - r.riders);
    for (const scenes::walkers::Person &person : tracks.people) {
        if (!person.track) continue;
        clq_track_info info = clq_track_info_init();
        check(clq_track_get_info(person.track.get(), &info));
        seconds += info.end_s - info.start_s, standing += info.standing_s;
        r.distance_m += info.distance_m;
        r.mean_shift_m += info.mean_shift_m / walkers;
        r.max_shift_m = std::max(r.max_shift_m, info.max_shift_m);
        r.plants += info.plant_count, r.bytes += info.bytes;
    }
    r.standing_share = seconds > 0 ? standing / seconds : 0;
    for (uint32_t i = 0; i < r.info.warning_count; ++i)
        r.warnings.emplace_back(clq_trajectories_get_warning(trajectories, i));
    return r;
}

void print(const TracksReport &r)
{
    const auto line = [](const char *what, const std::string &value) {
        std::printf("%-16s %s\n", what, value.c_str());
    };
    char text[240];
    std::snprintf(text, sizeof text, "%u, at most %u at once (%.2f s)", r.info.person_count, r.info.most_at_once,
                  r.info.most_at_once_s - r.info.min_s);
    line("people", text);
    std::snprintf(text, sizeof text, "%zu of these, and %zu in one", r.vehicles, r.riders);
    if (r.vehicles + r.riders > 0) line("vehicles", text);
    std::snprintf(text, sizeof text, "%.2f s, %.4g s between samples, %llu samples", r.info.max_s - r.info.min_s,
                  r.info.step_s, static_cast<unsigned long long>(r.info.sample_count));
    line("length", text);
    std::snprintf(text, sizeof text, "%.2f x %.2f m, x %.2f to %.2f, y %.2f to %.2f",
                  r.info.box_max_m[0] - r.info.box_min_m[0], r.info.box_max_m[1] - r.info.box_min_m[1],
                  r.info.box_min_m[0], r.info.box_max_m[0], r.info.box_min_m[1], r.info.box_max_m[1]);
    line("extent", text);
    std::snprintf(text, sizeof text, "median %.2f, 99 of 100 below %.2f, fastest %.2f m/s; %.1f %% below 0.1 m/s",
                  r.median_m_s, r.fast_m_s, r.fastest_m_s, 100 * r.slow_share);
    line("speed", text);
    line("headings", r.info.has_headings ? "from the file" : "along the paths");
    std::snprintf(text, sizeof text,
                  "%.0f m in %llu steps, standing %.1f %% of the time, %.3f m from the file in the mean, %.3f at most",
                  r.distance_m, static_cast<unsigned long long>(r.plants), 100 * r.standing_share, r.mean_shift_m,
                  r.max_shift_m);
    line("shown", text);
}

Json json_of(const TracksReport &r)
{
    Json out;
    out["file"] = r.file;
    out["people"] = r.info.person_count, out["most_at_once"] = r.info.most_at_once;
    out["vehicles"] = r.vehicles, out["riders"] = r.riders;
    out["samples"] = r.info.sample_count, out["length_s"] = r.info.max_s - r.info.min_s;
    out["step_s"] = r.info.step_s;
    out["box_m"] = {r.info.box_min_m[0], r.info.box_min_m[1], r.info.box_max_m[0], r.info.box_max_m[1]};
    out["speed_m_s"] = {{"median", r.median_m_s}, {"p99", r.fast_m_s}, {"max", r.fastest_m_s}};
    out["slow_share"] = r.slow_share;
    out["has_headings"] = r.info.has_headings;
    out["shown"] = {{"distance_m", r.distance_m},         {"steps", r.plants},
                    {"standing_share", r.standing_share}, {"mean_shift_m", r.mean_shift_m},
                    {"max_shift_m", r.max_shift_m},       {"bytes", r.bytes}};
    out["warnings"] = r.warnings;
    return out;
}

struct Arguments {
    TrackArguments tracks;
    scenes::Placement placed;
    MeasureArguments measures;
    std::string plot, json, out;
    uint64_t seed = 1;
};

scenes::walkers::OwnTrajectories load_record(scenes::Library &library, const Arguments &a,
                                             const scenes::walkers::Options &options, Progress &progress)
{
    constexpr double usual_rate_hz = 25;
    progress.phase("playing");
    const scenes::walkers::RecordPositions positions = scenes::walkers::positions_in(
        library, a.tracks.file, options.characters, a.tracks.rate_hz > 0 ? a.tracks.rate_hz : usual_rate_hz,
        [&](size_t done, size_t of) { progress.step(done, of); });
    auto trajectories = trajectories_of(library, positions, a.tracks.file, a.tracks.max_speed_m_s);
    if (!a.out.empty()) write_whole(a.out, position_file(a.out, positions));
    return trajectories;
}

void run(const Arguments &a)
{
    Progress progress("claque");
    if (!a.plot.empty()) expect_writable(a.plot);
    if (!a.json.empty()) expect_writable(a.json);
    if (!a.out.empty()) expect_writable(a.out);
    check_measures(a.measures, {a.json, a.plot});
    scenes::Library library(1);
    const scenes::walkers::Options options = walkers_of(a.tracks, a.placed);
    Tracks tracks;
    if (scenes::walkers::is_record(a.tracks.file)) {
        tracks.trajectories = load_record(library, a, options, progress);
    } else {
        progress.phase("reading");
        tracks.trajectories = scenes::walkers::load(library, options);
    }
    tracks.plan = scenes::walkers::plan_of(tracks.trajectories.get(), options);
    std::vector<scenes::walkers::Member> cast;
    std::vector<scenes::SocialClass> classes = options.characters;
    if (classes.empty()) classes.push_back(scenes::walkers::class_of("citizen"));
    for (const scenes::SocialClass &one : classes)
        cast.push_back(scenes::walkers::cast(library, one, scenes::Lod::off));
    scenes::walkers::People people(library, tracks.trajectories.get(), tracks.plan, cast, a.seed);
    tracks.people = people.take([&](size_t done, size_t of) { progress.step(done, of); });
    const TracksReport report = report_of(tracks, a.tracks.file);
    Json json = json_of(report);
    std::string measured;
    if (measures_any(a.measures)) {
        const Measures measures = write_measures(library, a.measures, tracks.trajectories.get(), a.tracks.file);
        measured = told(measures), json["measures"] = json_of(measures);
    }
    if (!a.plot.empty()) write_chart(a.plot, plan_drawing(tracks, report));
    if (!a.json.empty()) write_whole(a.json, json.dump(2) + "\n");
    if (a.json != "-" && a.plot != "-" && !is_printed(a.measures)) print(report), std::fputs(measured.c_str(), stdout);
}

void check_usage(const CLI::App &command, const Arguments &a)
{
    if (!scenes::walkers::is_record(a.tracks.file)) {
        if (a.out.empty()) return;
        throw CLI::ValidationError("--out", "writes the positions in a record; FILE is no record");
    }
    refuse_reading_options(command, true);
}

}  // namespace

void add_tracks(CLI::App &app, Work &chosen)
{
    auto a = std::make_shared<Arguments>();
    CLI::App *c = app.add_subcommand(
        "tracks",
        "Tell what is in a file of trajectories or a record, draw a plan of the paths, write a record's positions");
    c->add_option("FILE", a->tracks.file,
                  "Trajectories (docs/trajectories.md lists the formats), or a record (docs/records.md)")
        ->required();
    add_reading_options(*c, a->tracks);
    c->get_option("--rate")->description(
        "Frame numbers in a second, where the file does not say it; of a record: positions (25)");
    c->add_option("--characters", a->tracks.characters, "Who walks (default citizen)")->type_name("NAMES");
    add_limb_options(*c, a->tracks.limbs, a->tracks.gaits);
    add_placement_options(*c, a->placed);
    c->add_option("--seed", a->seed, "Seed of sizes and idle clips")->capture_default_str();
    c->add_option("--plot", a->plot, "Write the plan as SVG or PNG; - is standard output")->check(chart_file);
    c->add_option("--json", a->json, "Write the report as JSON; - is standard output");
    add_measure_options(*c, a->measures);
    c->add_option("--out,-o", a->out, "Write the positions in a record: id, frame, x, y, metres")
        ->check(CLI::Validator(check_position_file, ""))
        ->type_name("FILE.csv|FILE.txt|FILE.sqlite");
    c->callback([a, c, &chosen] {
        check_usage(*c, *a);
        chosen = [a] { run(*a); };
    });
}

}  // namespace cli
