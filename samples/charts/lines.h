// Line charts: several named series over one number, which may have a logarithmic scale.
#pragma once

#include <optional>

#include "samples/charts/axis_scale.h"
#include "samples/charts/drawing.h"

namespace charts
{

struct Axis {
    std::string title;
    Scale scale = Scale::linear;
    std::optional<double> from, to;  // minimum extent of the axis, if the values do not reach that far
};

struct Series {
    std::string name;
    std::vector<Point> points;
    std::optional<size_t> colour;  // default: the next one
    Dash dash = Dash::solid;
    enum class Dots { few, always, never } dots = Dots::few;  // few: if there are at most 30 points
};

struct LineChart {
    std::string title, subtitle;
    Axis x, y;
    std::vector<Series> series;
    std::string note;
};

Drawing drawing_of(const LineChart &chart);

// A line chart as a file:
//
//   { "kind": "lines", "title": "...", "subtitle": "...",
//     "x": { "title": "actors", "scale": "log", "from": 100, "to": 1e5 },
//     "y": { "title": "milliseconds a frame", "scale": "linear" },
//     "series": [ { "name": "actor", "points": [[100, 0.2], [1000, 1.9]],
//                   "colour": 1, "dash": "solid", "dots": "few" } ],
//     "note": "..." }
//
// scale: linear or log; dash: solid, dashed or dotted; dots: few, always or never; colour: 0 to 7. Title, series, names
// and points are required. Points go from left to right. `name` names the text in error messages. Throws
// scenes::Failure.
LineChart line_chart_of(const std::string &json, const std::string &name);
std::string json_of(const LineChart &chart);

}  // namespace charts
