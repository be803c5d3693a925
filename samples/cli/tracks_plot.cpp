// The plan of `claque tracks`.
#include <algorithm>
#include <cmath>

#include "samples/charts/frame.h"
#include "samples/charts/theme.h"
#include "samples/cli/tracks_report.h"

namespace cli
{
namespace
{

using charts::Ink;
using charts::Line;
using charts::Paint;

constexpr double max_height_px = 900, plot_step_s = 0.2;
constexpr size_t max_points = 200000;  // of all paths: a drawing that browsers still show

// Metres of the file to pixels: north is up.
struct PlanScale {
    double x0, y1, pixels, left, top;
    charts::Point at(double x, double y) const { return {left + (x - x0) * pixels, top + (y1 - y) * pixels}; }
};

// As many numbers as fit.
charts::AxisScale axis_of(double least, double largest, double pixels)
{
    constexpr double between_px = 60;
    return charts::axis_scale_of(charts::Scale::linear, least, std::max(largest, least + 1),
                                 std::max(2, std::min(12, static_cast<int>((largest - least) * pixels / between_px))),
                                 charts::Zero::near);
}

// A frame with ticks and numbers outside of it: lines across would be taken for paths.
void add_axes(charts::Sheet &sheet, const charts::AxisScale &x, const charts::AxisScale &y, const PlanScale &scale)
{
    constexpr double tick_px = 5;
    const Paint paint = {Ink::axis, 0};
    const charts::Point low = scale.at(x.from, y.from), high = scale.at(x.to, y.to);
    sheet.add(Line{{low, {high.x, low.y}, high, {low.x, high.y}, low}, paint});
    for (const double tick : x.ticks) {
        const double at = scale.at(tick, 0).x;
        sheet.add(Line{{{at, low.y}, {at, low.y + tick_px}}, paint});
        sheet.add(charts::Label{{at, low.y + 18}, tick_text(x, tick), charts::Face::detail, charts::Anchor::middle});
    }
    double widest = 0;
    for (const double tick : y.ticks) {
        const std::string text = tick_text(y, tick);
        const double at = scale.at(0, tick).y;
        widest = std::max(widest, charts::width_of(text, charts::Face::detail));
        sheet.add(Line{{{low.x - tick_px, at}, {low.x, at}}, paint});
        sheet.add(charts::Label{{low.x - 8, at + 4}, text, charts::Face::detail, charts::Anchor::end});
    }
    sheet.add(
        charts::Label{{(low.x + high.x) / 2, low.y + 38}, "x in m", charts::Face::detail, charts::Anchor::middle});
    sheet.add(charts::Label{{low.x - widest - 18, (low.y + high.y) / 2},
                            "y in m",
                            charts::Face::detail,
                            charts::Anchor::middle,
                            charts::Turn::upwards});
}

void add_given(charts::Sheet &sheet, const Tracks &tracks, const PlanScale &scale, uint64_t sample_count)
{
    const clq_trajectory_sample *samples = clq_trajectories_get_samples(tracks.trajectories.get());
    const uint64_t every = sample_count / max_points + 1;
    for (uint32_t p = 0; p < tracks.people.size(); ++p) {
        clq_trajectory_person person = clq_trajectory_person_init();
        scenes::check(clq_trajectories_get_person(tracks.trajectories.get(), p, &person));
        Line line{{}, {Ink::grid, 0}, 2.5};
        for (uint64_t i = 0; i < person.sample_count; i += every) {
            const clq_trajectory_sample &sample = samples[person.first_sample + i];
            line.points.push_back(scale.at(sample.x, sample.y));
        }
        if (line.points.size() > 1) sheet.add(std::move(line));
    }
}

void add_shown(charts::Sheet &sheet, const Tracks &tracks, const PlanScale &scale, double seconds)
{
    const double step = std::max(plot_step_s, seconds / max_points);
    for (size_t p = 0; p < tracks.people.size(); ++p) {
        const scenes::walkers::Person &person = tracks.people[p];
        if (!person.track) continue;
        const Paint paint = charts::series(1 + p % (charts::series_colours - 1));
        Line line{{}, paint, 1};
        bool stood = false;
        for (double t = person.start_s;; t += step) {
            const double at_s = std::min(t, person.end_s);
            clq_track_state state;
            scenes::check(clq_track_evaluate(person.track.get(), at_s, &state));
            const charts::Point at = scale.at(state.position[0] + tracks.plan.x, tracks.plan.y - state.position[2]);
            if (!state.stands || !stood) line.points.push_back(at);
            if (state.stands && !stood) sheet.add(charts::Dot{at, 2.2, paint});
            stood = state.stands;
            if (at_s >= person.end_s) break;
        }
        if (line.points.size() > 1) sheet.add(std::move(line));
    }
}

}  // namespace

charts::Drawing plan_drawing(const Tracks &tracks, const TracksReport &report)
{
    charts::Sheet sheet(64);
    const double width = std::max(1.0, report.info.box_max_m[0] - report.info.box_min_m[0]);
    const double height = std::max(1.0, report.info.box_max_m[1] - report.info.box_min_m[1]);
    char about[160];
    std::snprintf(about, sizeof about, "%u people in %.1f s, seen from above; a dot is a place where a person stands",
                  report.info.person_count, report.info.max_s - report.info.min_s);
    sheet.head(report.file, about);
    sheet.legend({{"as the file has it", {Ink::grid, 0}, charts::Fill::solid, charts::Dash::solid, 2.5},
                  {"as claque shows it", charts::series(1), charts::Fill::solid, charts::Dash::solid, 1}});
    const double room = sheet.right - sheet.left, pixels = std::min(room / width, max_height_px / height);
    const charts::AxisScale x = axis_of(report.info.box_min_m[0], report.info.box_max_m[0], pixels),
                            y = axis_of(report.info.box_min_m[1], report.info.box_max_m[1], pixels);
    const double fits = std::min(room / (x.to - x.from), max_height_px / (y.to - y.from));
    const double left = sheet.left + (room - (x.to - x.from) * fits) / 2;
    const PlanScale scale{x.from, y.to, fits, left, sheet.y + 12};
    double seconds = 0;
    for (const scenes::walkers::Person &person : tracks.people) seconds += person.end_s - person.start_s;
    add_axes(sheet, x, y, scale);
    add_given(sheet, tracks, scale, report.info.sample_count);
    add_shown(sheet, tracks, scale, seconds);
    sheet.y += 12 + (y.to - y.from) * fits + 46;
    return sheet.finish("Paths of the people in " + report.file);
}

}  // namespace cli
