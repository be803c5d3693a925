// The measurements of `claque bench --json` along a camera path, as a chart in the manner of S1's Fig. 8.
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "samples/cli/cache_choice.h"
#include "samples/cli/plot.h"
#include "samples/io/json.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace
{

using Json = nlohmann::ordered_json;
using charts::BarChart;
using charts::Fill;
using charts::Panel;

constexpr int most_side_px = 1 << 20;

// A report as it was read. Every access is checked, because files come from anywhere.
class Report
{
public:
    Report(const std::string &report, const std::string &name) : name_(name)
    {
        std::string problem;
        json_ = io::parse_json<Json>(report, problem);
        if (!problem.empty()) refuse("it " + problem);
    }

    const Json &root() const { return json_; }
    const Json &member(const Json &of, const char *name) const
    {
        if (!of.is_object() || !of.contains(name)) refuse("it lacks '" + std::string(name) + "'");
        return of[name];
    }
    std::string text(const Json &of, const char *name) const
    {
        const Json &found = member(of, name);
        if (!found.is_string()) refuse("its '" + std::string(name) + "' is not a string");
        return found.get<std::string>();
    }
    double number(const Json &of, const char *name) const
    {
        const Json &found = member(of, name);
        if (!found.is_number() || !(found.get<double>() >= 0) || !(found.get<double>() < 1e12))
            refuse("its '" + std::string(name) + "' is not a number of at least 0");
        return found.get<double>();
    }
    const Json &list(const char *name) const
    {
        const Json &found = member(json_, name);
        if (!found.is_array() || found.empty()) refuse("its '" + std::string(name) + "' is not a list, or empty");
        return found;
    }
    // The values under `key` of all members of list `name`, in the order of their first appearance.
    std::vector<std::string> different(const char *name, const char *key) const
    {
        std::vector<std::string> found;
        for (const Json &one : list(name)) {
            const std::string now = text(one, key);
            if (std::find(found.begin(), found.end(), now) == found.end()) found.push_back(now);
        }
        return found;
    }
    [[noreturn]] void refuse(const std::string &why) const
    {
        throw scenes::Failure(name_ + " is not a report of 'claque bench SCENE --json' along a camera path: " + why);
    }

private:
    std::string name_;
    Json json_;
};

// One value for each section, cluster and cache; negative where it was not measured.
using Measure = double (*)(const Report &, const Json &run);

Panel panel_of(const Report &report, const BarChart &chart, const std::vector<std::string> &strategies, Measure measure)
{
    Panel panel;
    panel.values.assign(chart.groups.size(), std::vector<std::vector<double>>(
                                                 strategies.size(), std::vector<double>(chart.colours.size(), -1)));
    for (const Json &run : report.list("runs"))
        for (size_t g = 0; g < chart.groups.size(); ++g)
            for (size_t v = 0; v < strategies.size(); ++v)
                for (size_t c = 0; c < chart.colours.size(); ++c)
                    if (report.text(run, "section") == chart.groups[g].name &&
                        report.text(run, "strategy") == strategies[v] &&
                        "caches: " + report.text(run, "cache") == chart.colours[c])
                        panel.values[g][v][c] = measure(report, run);
    return panel;
}

double frames_a_second(const Report &report, const Json &run)
{
    const double ms = report.number(report.member(run, "frame_ms"), "median");
    return ms > 0 ? 1000 / ms : 0;
}

double update_ms(const Report &report, const Json &run)
{
    return report.number(report.member(run, "update_ms"), "median");
}

double draw_ms(const Report &report, const Json &run) { return report.number(report.member(run, "draw_ms"), "median"); }

// The range of the library's share of a frame's time, for the note below.
std::string library_share(const Report &report, const std::string &strategy)
{
    double least = 1, most = 0;
    for (const Json &run : report.list("runs")) {
        if (report.text(run, "strategy") != strategy) continue;
        const double frame = report.number(report.member(run, "frame_ms"), "median");
        const double share = frame > 0 ? update_ms(report, run) / frame : 0;
        least = std::min(least, share);
        most = std::max(most, share);
    }
    return std::to_string(std::lround(100 * least)) + " to " + std::to_string(std::lround(100 * most)) + " %";
}

BarChart chart_of(const Report &report)
{
    BarChart chart;
    const std::string scene = report.text(report.root(), "scene");
    chart.title = "The " + scene + " along its camera path: what caches and draw strategies cost";
    bool key_poses = false, levels = false;
    for (const std::string &cache : report.different("runs", "cache")) {
        chart.colours.push_back("caches: " + cache);
        key_poses = key_poses || shares_key_poses(cache);
        levels = levels || cache.find(", levels") != std::string::npos;
    }
    if (chart.colours.size() > charts::series_colours)
        report.refuse("it has more than " + std::to_string(charts::series_colours) + " caches");
    chart.subtitle = std::to_string(std::lround(report.number(report.root(), "count"))) + " people, medians of " +
                     std::to_string(std::lround(report.number(report.root(), "frames"))) +
                     " frames a section; all bars of a section show the same pictures";
    if (levels) chart.subtitle += ", with levels of detail different ones than without";
    if (key_poses) chart.subtitle += ", except that each key-pose mode has its own";
    for (const Json &section : report.list("sections")) {
        const Json &people = report.member(section, "people");
        chart.groups.push_back({report.text(section, "name"),
                                std::to_string(std::lround(report.number(people, "mean"))) + " people in view"});
    }
    const std::vector<std::string> measured = report.different("runs", "strategy");
    std::vector<std::string> strategies;
    for (const char *wanted : {"per-zone", "fused"})
        if (std::find(measured.begin(), measured.end(), wanted) != measured.end()) strategies.emplace_back(wanted);
    if (strategies.empty()) strategies.push_back(measured.front());

    Panel frames = panel_of(report, chart, strategies, frames_a_second);
    frames.title = "Whole frames: library, environment and crowd with GL";
    frames.unit = "frames a second";
    for (size_t v = 0; v < strategies.size(); ++v)
        frames.clusters.push_back({strategies[v], v + 1 < strategies.size() ? Fill::hatched : Fill::solid});
    chart.panels.push_back(frames);

    Panel update = panel_of(report, chart, {strategies.back()}, update_ms);
    update.title = "The library's share of them: culling, poses, skinning";
    update.unit = "milliseconds a frame";
    update.clusters.push_back({"", Fill::solid});
    update.height_px = 150;
    chart.panels.push_back(update);

    if (key_poses) {
        Panel draw = panel_of(report, chart, {strategies.back()}, draw_ms);
        draw.title = "Drawing the crowd, with GL: the part that key-poses cannot save";
        draw.unit = update.unit;
        draw.clusters.push_back({"", Fill::solid});
        draw.height_px = update.height_px;
        chart.panels.push_back(draw);
    }

    const Json &machine = report.member(report.root(), "machine"), &size = report.member(report.root(), "size_px");
    if (!size.is_array() || size.size() != 2 || !io::whole_in(size[0], 1, most_side_px) ||
        !io::whole_in(size[1], 1, most_side_px))
        report.refuse("its 'size_px' is not a size");
    chart.notes.push_back("The library takes " + library_share(report, strategies.back()) + " of a frame (" +
                          strategies.back() + "). Higher is better above, lower is better below it.");
    chart.notes.push_back(report.text(machine, "processor") + ", " +
                          std::to_string(std::lround(report.number(machine, "cores"))) + " cores, " +
                          report.text(report.root(), "context") + ", " + std::to_string(size[0].get<int>()) + " x " +
                          std::to_string(size[1].get<int>()) + ", claque " + report.text(report.root(), "claque"));
    return chart;
}

}  // namespace

charts::BarChart path_chart_of(const std::string &json, const std::string &name)
{
    return chart_of(Report(json, name));
}

}  // namespace cli
