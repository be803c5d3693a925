// Line charts as JSON: round trip and refusals.
#include <gtest/gtest.h>

#include "samples/charts/lines.h"
#include "samples/scenes/check.h"

namespace charts
{
namespace
{

constexpr const char *whole = R"({"kind": "lines", "title": "Growth", "subtitle": "one core",
    "x": {"title": "actors", "scale": "log", "from": 100, "to": 1e5},
    "y": {"title": "ms", "scale": "linear"},
    "series": [{"name": "actor", "points": [[100, 0.2], [1000, 1.9]], "colour": 3, "dash": "dotted", "dots": "never"},
               {"name": "traditional", "points": [[100, 2]]}],
    "note": "fine"})";

TEST(LinesJson, EveryMemberIsReadIntoItsField)
{
    const LineChart chart = line_chart_of(whole, "f");
    EXPECT_EQ(chart.title, "Growth");
    EXPECT_EQ(chart.subtitle, "one core");
    EXPECT_EQ(chart.note, "fine");
    EXPECT_EQ(chart.x.title, "actors");
    EXPECT_EQ(chart.x.scale, Scale::logarithmic);
    EXPECT_EQ(chart.x.from, 100);
    EXPECT_EQ(chart.x.to, 1e5);
    EXPECT_EQ(chart.y.scale, Scale::linear);
    EXPECT_FALSE(chart.y.from.has_value());
    ASSERT_EQ(chart.series.size(), 2u);
    EXPECT_EQ(chart.series[0].points[1].x, 1000);
    EXPECT_EQ(chart.series[0].points[1].y, 1.9);
    EXPECT_EQ(chart.series[0].colour, 3u);
    EXPECT_EQ(chart.series[0].dash, Dash::dotted);
    EXPECT_EQ(chart.series[0].dots, Series::Dots::never);
    EXPECT_EQ(chart.series[1].name, "traditional");
    EXPECT_FALSE(chart.series[1].colour.has_value());
    EXPECT_EQ(chart.series[1].dash, Dash::solid);
}

TEST(LinesJson, WhatIsWrittenIsDrawnTheSame)
{
    const LineChart chart = line_chart_of(whole, "f");
    EXPECT_EQ(svg_of(drawing_of(chart)), svg_of(drawing_of(line_chart_of(json_of(chart), "g"))));
}

TEST(LinesJson, WhatIsWrongIsSaid)
{
    const auto with = [](const std::string &from, const std::string &to) {
        std::string text = whole;
        return text.replace(text.find(from), from.size(), to);
    };
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {"nothing", "it is not JSON"},
        {std::string(300000, '['), "it is nested more than 64 deep"},
        {"[]", "'kind' is not 'lines'"},
        {with("\"lines\"", "\"pie\""), "'kind' is not 'lines'"},
        {with("\"lines\"", "7"), "its 'kind' is not a string"},
        {with("\"title\": \"Growth\"", "\"title\": \"\""), "it has no 'title'"},
        {with("\"log\"", "\"cubic\""), "its 'x': 'scale' is 'cubic', not linear or log"},
        {with("\"from\": 100", "\"from\": 0"), "its 'x': 'from' is not a number above 0"},
        {with("[[100, 2]]", "[[0, 2]]"), "series 2: point 1: x is not a number above 0, as a logarithmic axis needs"},
        {with("[[100, 2]]", "[[100, 1e300]]"), "series 2: point 1: y is not a number from -1e15 to 1e15"},
        {with("[[100, 2]]", "[[100, null]]"), "series 2: point 1: y is not a number"},
        {with("[[100, 2]]", "[[100]]"), "series 2: point 1 is not a pair [x, y]"},
        {with("[[100, 2]]", "[]"), "series 2: 'points' is not a list of 1 to"},
        {with("[1000, 1.9]", "[10, 1.9]"), "series 1: point 2 lies left of the one before it"},
        {with("\"colour\": 3", "\"colour\": 8"), "series 1: 'colour' is not a whole number from 0 to 7"},
        {with("\"dotted\"", "\"wavy\""), "series 1: 'dash' is 'wavy', not solid, dashed or dotted"},
        {with("\"name\": \"actor\", ", ""), "series 1: it has no 'name'"},
        {R"({"kind": "lines", "title": "t"})", "its 'series' is not a list of 1 to 16"},
        {R"({"kind": "lines", "title": "t", "series": [4]})", "series 1 is not an object"},
        {R"({"kind": "lines", "title": "t", "x": 4})", "its 'x' is not an object"},
    };
    for (const auto &[text, said] : wrong) {
        try {
            line_chart_of(text, "growth.json");
            ADD_FAILURE() << "taken: " << text;
        } catch (const scenes::Failure &failure) {
            EXPECT_NE(std::string(failure.what()).find(said), std::string::npos) << failure.what() << "\n" << said;
            EXPECT_EQ(std::string(failure.what()).rfind("growth.json is not a line chart: ", 0), 0u);
        }
    }
}

}  // namespace
}  // namespace charts
