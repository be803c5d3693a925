// Line charts as drawn: curves, legend, marks and axes.
#include "samples/charts/lines.h"

#include <gtest/gtest.h>

#include "samples/charts/theme.h"

namespace charts
{
namespace
{

LineChart two_lines(Scale scale)
{
    LineChart chart;
    chart.title = "Two";
    chart.x = {"x", scale, {}, {}};
    chart.y = {"y", scale, {}, {}};
    chart.series = {{"up", {{1, 1}, {10, 10}, {100, 100}}, {}}, {"down", {{1, 100}, {100, 1}}, {}, Dash::dashed}};
    chart.note = "A note.";
    return chart;
}

std::vector<Line> lines_in(const Drawing &drawing)
{
    std::vector<Line> found;
    for (const Mark &mark : drawing.marks)
        if (const Line *line = std::get_if<Line>(&mark); line && line->paint.ink == Ink::series && line->width > 1)
            found.push_back(*line);
    return found;  // first the legend's, then the curves
}

TEST(Lines, APowerIsStraightOnLogarithmicAxesAndBentOnOne)
{
    const std::vector<Line> straight = lines_in(drawing_of(two_lines(Scale::logarithmic)));
    ASSERT_EQ(straight.size(), 4u);
    EXPECT_NEAR(straight[2].points[1].x, (straight[2].points[0].x + straight[2].points[2].x) / 2, 1e-9);
    EXPECT_NEAR(straight[2].points[1].y, (straight[2].points[0].y + straight[2].points[2].y) / 2, 1e-9);
    LineChart half = two_lines(Scale::logarithmic);
    half.y.scale = Scale::linear;
    const Line bent = lines_in(drawing_of(half))[2];
    EXPECT_GT(bent.points[1].y, (bent.points[0].y + bent.points[2].y) / 2 + 50);
}

TEST(Lines, ColoursAndDashesOfTheLegendAreThoseOfTheCurves)
{
    const std::vector<Line> lines = lines_in(drawing_of(two_lines(Scale::linear)));
    ASSERT_EQ(lines.size(), 4u);
    for (size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(lines[i].paint.series, lines[i + 2].paint.series);
        EXPECT_EQ(lines[i].dash, lines[i + 2].dash);
    }
    EXPECT_NE(lines[0].paint.series, lines[1].paint.series);
}

TEST(Lines, CurvesAreInThePixelsInTheirColours)
{
    const Drawing drawing = drawing_of(two_lines(Scale::linear));
    const Pixels p = pixels_of(drawing, 2);
    const std::vector<Line> lines = lines_in(drawing);
    const Point at = lines[2].points[1];
    const size_t i = 3 * (static_cast<size_t>(2 * at.y) * static_cast<size_t>(p.width) + static_cast<size_t>(2 * at.x));
    const Colour c = colour_of(lines[2].paint, light);
    EXPECT_EQ(p.rgb[i], c.red);
    EXPECT_EQ(p.rgb[i + 1], c.green);
    EXPECT_EQ(p.rgb[i + 2], c.blue);
}

TEST(Lines, EveryMarkIsOnTheSheetWhateverTheTexts)
{
    LineChart chart = two_lines(Scale::logarithmic);
    chart.title = chart.subtitle = chart.note = std::string("word ") + std::string(40, 'm');
    for (int i = 0; i < 5; ++i) chart.note += " " + chart.note;
    for (int i = 0; i < 12; ++i)
        chart.series.push_back({"series with a long name " + std::to_string(i), {{50, 7}}, {}});
    const Drawing drawing = drawing_of(chart);
    for (const Mark &mark : drawing.marks)
        if (const Label *label = std::get_if<Label>(&mark)) {
            const double wide = label->turn == Turn::level ? width_of(label->text, label->face) : 0;
            const double left = label->at.x - wide * (label->anchor == Anchor::start    ? 0
                                                      : label->anchor == Anchor::middle ? 0.5
                                                                                        : 1);
            EXPECT_GE(left, 0) << label->text;
            EXPECT_LE(left + wide, drawing.width_px) << label->text;
            EXPECT_LE(label->at.y, drawing.height_px) << label->text;
        }
}

TEST(Lines, LinearHeightsStartAtZero)
{
    LineChart chart = two_lines(Scale::linear);
    chart.series = {{"high", {{0, 90}, {1, 100}}, {}}};
    bool zero = false;
    for (const Mark &mark : drawing_of(chart).marks)
        if (const Label *label = std::get_if<Label>(&mark))
            zero = zero || (label->text == "0" && label->anchor == Anchor::end);
    EXPECT_TRUE(zero);
}

}  // namespace
}  // namespace charts
