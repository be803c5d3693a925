// Line charts: several named series over one number, which may be scaled by its logarithm.
#pragma once

#include "samples/charts/axis_scale.h"
#include "samples/charts/drawing.h"

#include <optional>

namespace charts
{

struct Axis {
    std::string title;
    Scale scale = Scale::linear;
    std::optional<double> from, to;  // shown at least, where values do not reach so far
};

struct Series {
    std::string name;
    std::vector<Point> points;
    std::optional<size_t> colour;  // the next one, if not said
    Dash dash = Dash::solid;
    enum class Dots { few, always, never } dots = Dots::few;  // few: where there are at most 30 points
};

struct LineChart {
    std::string title, subtitle;
    Axis x, y;
    std::vector<Series> series;
    std::string note;
};

Drawing drawing_of(const LineChart &chart);

// The chart as it is written in a file:
//
//   { "kind": "lines", "title": "...", "subtitle": "...",
//     "x": { "title": "actors", "scale": "log", "from": 100, "to": 1e5 },
//     "y": { "title": "milliseconds a frame", "scale": "linear" },
//     "series": [ { "name": "actor", "points": [[100, 0.2], [1000, 1.9]],
//                   "colour": 1, "dash": "solid", "dots": "few" } ],
//     "note": "..." }
//
// scale: linear or log; dash: solid, dashed or dotted; dots: few, always or never; colour: 0 to 7. Title, series, names and
// points have to be there. Points go from left to right. `name` is what refusals call the text. Throws scenes::Failure.
LineChart line_chart_of(const std::string &json, const std::string &name);
std::string json_of(const LineChart &chart);

}  // namespace charts
