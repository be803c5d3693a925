// Drawing primitives of charts as SVG text and as pixels.
#include "samples/charts/drawing.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "samples/charts/bars.h"
#include "samples/charts/theme.h"

namespace charts
{
namespace
{

std::array<int, 3> pixel(const Pixels &p, int x, int y)
{
    const size_t at = 3 * (static_cast<size_t>(y) * static_cast<size_t>(p.width) + static_cast<size_t>(x));
    return {p.rgb[at], p.rgb[at + 1], p.rgb[at + 2]};
}
std::array<int, 3> shown(const Paint &paint)
{
    const Colour c = colour_of(paint, light);
    return {c.red, c.green, c.blue};
}
constexpr std::array<int, 3> white = {255, 255, 255};

Drawing sheet(std::vector<Mark> marks) { return {60, 40, "A <title> & more", std::move(marks)}; }

TEST(Drawing, MarksHaveTheirColoursWhereTheyAre)
{
    const Pixels p = pixels_of(sheet({Box{{10, 10}, 10, 10, series(1), series(1)},
                                      Line{{{30, 5}, {30, 35}}, series(2), 4}, Dot{{45, 20}, 5, series(3)}}),
                               2);
    EXPECT_EQ(p.width, 120);
    EXPECT_EQ(p.height, 80);
    EXPECT_EQ(p.rgb.size(), 3u * 120 * 80);
    EXPECT_EQ(pixel(p, 30, 30), shown(series(1)));
    EXPECT_EQ(pixel(p, 60, 40), shown(series(2)));
    EXPECT_EQ(pixel(p, 90, 40), shown(series(3)));
    EXPECT_EQ(pixel(p, 5, 5), white);
    EXPECT_EQ(pixel(p, 60, 76), white);
}

TEST(Drawing, LettersLeaveInkOnTheSideOfTheirAnchor)
{
    for (const Anchor anchor : {Anchor::start, Anchor::end}) {
        const Pixels p = pixels_of(sheet({Label{{30, 25}, "ab", Face::plain, anchor}}), 1);
        int left = 0, right = 0;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 60; ++x)
                if (pixel(p, x, y) != white) (x < 30 ? left : right) += 1;
        EXPECT_GT(anchor == Anchor::start ? right : left, 20);
        EXPECT_LE(anchor == Anchor::start ? left : right, 3);
    }
}

TEST(Drawing, UprightLettersRunUpwards)
{
    const Pixels p = pixels_of(sheet({Label{{30, 38}, "abcd", Face::plain, Anchor::start, Turn::upwards}}), 1);
    int inked_rows = 0;
    for (int y = 0; y < 40; ++y) {
        bool inked = false;
        for (int x = 0; x < 60; ++x) inked = inked || pixel(p, x, y) != white;
        inked_rows += inked;
    }
    EXPECT_GT(inked_rows, 18) << "four letters are wider than one is high";
}

TEST(Drawing, PatternsLeavePartOfTheGroundAndARim)
{
    for (const Fill fill : {Fill::hatched, Fill::dotted}) {
        const Pixels p = pixels_of(sheet({Box{{10, 5}, 40, 30, series(4), series(4), fill}}), 2);
        int coloured = 0, ground = 0;
        for (int y = 14; y < 66; ++y)
            for (int x = 24; x < 96; ++x) {
                coloured += pixel(p, x, y) == shown(series(4));
                ground += pixel(p, x, y) == white;
            }
        EXPECT_GT(coloured, 52 * 72 / 8);
        EXPECT_GT(ground, 52 * 72 / 5);
    }
}

TEST(Drawing, DashesHaveGaps)
{
    const Pixels p = pixels_of(sheet({Line{{{2, 20}, {58, 20}}, series(1), 2, Dash::dashed}}), 2);
    int changes = 0;
    for (int x = 5; x < 115; ++x) changes += (pixel(p, x, 40) == white) != (pixel(p, x + 1, 40) == white);
    EXPECT_GE(changes, 6);
}

TEST(Drawing, TheSameDrawingGivesTheSameBytes)
{
    const Drawing drawing = sheet({Box{{10, 5}, 40, 30, series(4), series(4), Fill::hatched},
                                   Label{{30, 25}, "äöü & <b>", Face::title, Anchor::middle}});
    EXPECT_EQ(pixels_of(drawing, 2).rgb, pixels_of(drawing, 2).rgb);
    EXPECT_EQ(svg_of(drawing), svg_of(drawing));
}

TEST(Drawing, SvgIsEscapedAndFollowsBothThemes)
{
    const std::string svg = svg_of(sheet({Label{{30, 25}, "1 < 2 & \"so\"", Face::plain}}));
    EXPECT_EQ(svg.rfind("<svg", 0), 0u);
    EXPECT_NE(svg.find("<title>A &lt;title&gt; &amp; more</title>"), std::string::npos);
    EXPECT_NE(svg.find(">1 &lt; 2 &amp; &quot;so&quot;</text>"), std::string::npos);
    EXPECT_NE(svg.find("prefers-color-scheme: dark"), std::string::npos);
}

TEST(Drawing, SvgDefinesEveryPatternItUses)
{
    const std::string svg = svg_of(sheet({Box{{1, 1}, 5, 5, series(4), series(4), Fill::hatched},
                                          Box{{9, 1}, 5, 5, {Ink::text, 0}, {Ink::text, 0}, Fill::dotted}}));
    size_t used = 0;
    for (size_t at = 0; (at = svg.find("url(#", at)) != std::string::npos; ++at, ++used) {
        const std::string name = svg.substr(at + 5, svg.find(')', at) - at - 5);
        EXPECT_NE(svg.find("id=\"" + name + "\""), std::string::npos) << name;
    }
    EXPECT_EQ(used, 2u);
}

TEST(Drawing, ColoursAreToldApart)
{
    for (size_t a = 0; a < series_colours; ++a)
        for (size_t b = a + 1; b < series_colours; ++b) {
            const auto one = shown(series(a)), other = shown(series(b));
            EXPECT_GT(std::abs(one[0] - other[0]) + std::abs(one[1] - other[1]) + std::abs(one[2] - other[2]), 60);
        }
}

TEST(Drawing, BarsAreAsHighAsTheirValues)
{
    BarChart chart;
    chart.title = "Heights";
    chart.colours = {"a", "b"};
    chart.groups = {{"one", ""}};
    Panel panel;
    panel.clusters = {{"", Fill::solid}};
    panel.values = {{{25, 100}}};
    chart.panels = {panel};
    std::vector<double> heights;
    for (const Mark &mark : drawing_of(chart).marks)
        if (const Box *box = std::get_if<Box>(&mark); box && box->paint.ink == Ink::series && box->width > 20)
            heights.push_back(box->height);
    ASSERT_EQ(heights.size(), 2u);
    EXPECT_NEAR(heights[1] / heights[0], 4, 1e-9);
}

}  // namespace
}  // namespace charts
