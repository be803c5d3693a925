// Line charts read from JSON; what is wrong is named with its place.
#include <array>

#include <nlohmann/json.hpp>

#include "samples/charts/lines.h"
#include "samples/io/json.h"
#include "samples/scenes/check.h"

namespace charts
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr std::array<const char *, 2> scales = {"linear", "log"};
constexpr std::array<const char *, 3> dashes = {"solid", "dashed", "dotted"}, dots = {"few", "always", "never"};
constexpr size_t most_series = 16, most_points = 100000;
constexpr double most_value = 1e15, least_logarithmic = 1e-12;

class Reader
{
public:
    explicit Reader(std::string name) : name_(std::move(name)) {}

    [[noreturn]] void refuse(const std::string &why) const
    {
        throw scenes::Failure(name_ + " is not a line chart: " + why);
    }
    std::string text(const Json &of, const char *key, const std::string &whose) const
    {
        if (!of.contains(key)) return "";
        if (!of[key].is_string()) refuse(whose + "'" + key + "' is not a string");
        return of[key].get<std::string>();
    }
    template <class Choice, size_t n>
    Choice choice(const Json &of, const char *key, const std::array<const char *, n> &words,
                  const std::string &whose) const
    {
        const std::string word = text(of, key, whose);
        std::string all;
        for (size_t i = 0; i < n; ++i) {
            if (word == words[i] || (word.empty() && i == 0)) return static_cast<Choice>(i);
            all += (i == 0 ? "" : i + 1 < n ? ", " : " or ") + std::string(words[i]);
        }
        refuse(whose + "'" + key + "' is '" + word + "', not " + all);
    }
    double number(const Json &value, Scale scale, const std::string &what) const
    {
        const double least = scale == Scale::logarithmic ? least_logarithmic : -most_value;
        if (!value.is_number() || !(value.get<double>() >= least) || !(value.get<double>() <= most_value))
            refuse(what + " is not a number" +
                   (scale == Scale::logarithmic ? " above 0, as a logarithmic axis needs" : " from -1e15 to 1e15"));
        return value.get<double>();
    }

private:
    std::string name_;
};

Axis axis_of(const Reader &reader, const Json &json, const char *key)
{
    Axis axis;
    if (!json.contains(key)) return axis;
    const Json &found = json[key];
    const std::string whose = "its '" + std::string(key) + "': ";
    if (!found.is_object()) reader.refuse("its '" + std::string(key) + "' is not an object");
    axis.title = reader.text(found, "title", whose);
    axis.scale = reader.choice<Scale>(found, "scale", scales, whose);
    if (found.contains("from")) axis.from = reader.number(found["from"], axis.scale, whose + "'from'");
    if (found.contains("to")) axis.to = reader.number(found["to"], axis.scale, whose + "'to'");
    return axis;
}

Series series_of(const Reader &reader, const Json &json, const LineChart &chart, const std::string &number)
{
    const std::string whose = "series " + number + ": ";
    if (!json.is_object()) reader.refuse("series " + number + " is not an object");
    Series one;
    one.name = reader.text(json, "name", whose);
    if (one.name.empty()) reader.refuse(whose + "it has no 'name'");
    one.dash = reader.choice<Dash>(json, "dash", dashes, whose);
    one.dots = reader.choice<Series::Dots>(json, "dots", dots, whose);
    if (json.contains("colour")) {
        if (!json["colour"].is_number_unsigned() || json["colour"].get<uint64_t>() >= series_colours)
            reader.refuse(whose + "'colour' is not a whole number from 0 to " + std::to_string(series_colours - 1));
        one.colour = json["colour"].get<size_t>();
    }
    if (!json.contains("points") || !json["points"].is_array() || json["points"].empty() ||
        json["points"].size() > most_points)
        reader.refuse(whose + "'points' is not a list of 1 to " + std::to_string(most_points));
    for (const Json &point : json["points"]) {
        const std::string which = whose + "point " + std::to_string(one.points.size() + 1);
        if (!point.is_array() || point.size() != 2) reader.refuse(which + " is not a pair [x, y]");
        one.points.push_back({reader.number(point[0], chart.x.scale, which + ": x"),
                              reader.number(point[1], chart.y.scale, which + ": y")});
        if (one.points.size() > 1 && one.points.back().x < one.points[one.points.size() - 2].x)
            reader.refuse(which + " lies left of the one before it");
    }
    return one;
}

Json json_of(const Axis &axis)
{
    Json json = {{"title", axis.title}, {"scale", scales[static_cast<size_t>(axis.scale)]}};
    if (axis.from) json["from"] = *axis.from;
    if (axis.to) json["to"] = *axis.to;
    return json;
}

}  // namespace

LineChart line_chart_of(const std::string &file, const std::string &name)
{
    const Reader reader(name);
    std::string problem;
    const Json json = io::parse_json<Json>(file, problem);
    if (!problem.empty()) reader.refuse("it " + problem);
    if (!json.is_object() || reader.text(json, "kind", "its ") != "lines") reader.refuse("its 'kind' is not 'lines'");
    LineChart chart;
    chart.title = reader.text(json, "title", "its ");
    if (chart.title.empty()) reader.refuse("it has no 'title'");
    chart.subtitle = reader.text(json, "subtitle", "its ");
    chart.note = reader.text(json, "note", "its ");
    chart.x = axis_of(reader, json, "x");
    chart.y = axis_of(reader, json, "y");
    if (!json.contains("series") || !json["series"].is_array() || json["series"].empty() ||
        json["series"].size() > most_series)
        reader.refuse("its 'series' is not a list of 1 to " + std::to_string(most_series));
    for (const Json &one : json["series"])
        chart.series.push_back(series_of(reader, one, chart, std::to_string(chart.series.size() + 1)));
    return chart;
}

std::string json_of(const LineChart &chart)
{
    Json json = {{"kind", "lines"},       {"title", chart.title},  {"subtitle", chart.subtitle},
                 {"x", json_of(chart.x)}, {"y", json_of(chart.y)}, {"series", Json::array()},
                 {"note", chart.note}};
    for (const Series &one : chart.series) {
        Json series = {{"name", one.name},
                       {"dash", dashes[static_cast<size_t>(one.dash)]},
                       {"dots", dots[static_cast<size_t>(one.dots)]}};
        if (one.colour) series["colour"] = *one.colour;
        series["points"] = Json::array();
        for (const Point &point : one.points) series["points"].push_back({point.x, point.y});
        json["series"].push_back(series);
    }
    return json.dump() + "\n";
}

}  // namespace charts
