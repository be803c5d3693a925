#include "samples/charts/lines.h"

#include <algorithm>
#include <limits>

#include "samples/charts/frame.h"
#include "samples/charts/theme.h"

namespace charts
{
namespace
{

constexpr double plot_height_px = 380, line_width_px = 2.2, dot_radius_px = 3.4;

// The first colour, a grey, comes last.
size_t colour_of(const LineChart &chart, size_t i) { return chart.series[i].colour.value_or(i + 1); }

AxisScale ruler_along(const LineChart &chart, const Axis &axis, double Point::*part, int most, Zero zero)
{
    double least = std::numeric_limits<double>::infinity(), largest = -least;
    for (const Series &one : chart.series)
        for (const Point &point : one.points) {
            least = std::min(least, point.*part);
            largest = std::max(largest, point.*part);
        }
    return axis_scale_of(axis.scale, std::min(least, axis.from.value_or(least)),
                         std::max(largest, axis.to.value_or(largest)), most, zero);
}

double widest_tick(const AxisScale &axis_scale)
{
    double widest = 0;
    for (const double tick : axis_scale.ticks)
        widest = std::max(widest, width_of(tick_text(axis_scale, tick), Face::detail));
    return widest;
}

// As many numbers as fit side by side.
AxisScale ruler_below(const LineChart &chart, double width)
{
    int most = 12;
    AxisScale axis_scale = ruler_along(chart, chart.x, &Point::x, most, Zero::near);
    while (most > 2 && (widest_tick(axis_scale) + 14) * static_cast<double>(axis_scale.ticks.size() - 1) > width)
        axis_scale = ruler_along(chart, chart.x, &Point::x, --most, Zero::near);
    return axis_scale;
}

void level(Sheet &sheet, const AxisScale &axis_scale, double top, double bottom, const std::string &title)
{
    for (const double tick : axis_scale.ticks) {
        const double at = sheet.left + axis_scale.share(tick) * (sheet.right - sheet.left);
        sheet.add(Line{{{at, top}, {at, bottom}}, {tick == axis_scale.from ? Ink::axis : Ink::grid, 0}});
        const bool last = tick == axis_scale.ticks.back();  // kept on the sheet
        sheet.add(
            Label{{last ? std::min(at, sheet.right - width_of(tick_text(axis_scale, tick), Face::detail) / 2 + 16) : at,
                   bottom + 18},
                  tick_text(axis_scale, tick),
                  Face::detail,
                  Anchor::middle});
    }
    sheet.add(Label{{(sheet.left + sheet.right) / 2, bottom + 38}, title, Face::detail, Anchor::middle});
}

}  // namespace

Drawing drawing_of(const LineChart &chart)
{
    const AxisScale y = ruler_along(chart, chart.y, &Point::y, 8, Zero::always);
    Sheet sheet(std::max(64.0, 44 + widest_tick(y)));
    const AxisScale x = ruler_below(chart, sheet.right - sheet.left);
    sheet.head(chart.title, chart.subtitle);
    std::vector<Sheet::Swatch> swatches;
    for (size_t i = 0; i < chart.series.size(); ++i)
        swatches.push_back(
            {chart.series[i].name, series(colour_of(chart, i)), Fill::solid, chart.series[i].dash, line_width_px});
    sheet.legend(swatches);

    const double top = sheet.y + 8, bottom = top + plot_height_px;
    level(sheet, x, top, bottom, chart.x.title);
    sheet.upright(y, top, bottom, chart.y.title);
    for (size_t i = 0; i < chart.series.size(); ++i) {
        Line line = {{}, series(colour_of(chart, i)), line_width_px, chart.series[i].dash};
        for (const Point &point : chart.series[i].points)
            line.points.push_back({sheet.left + x.share(point.x) * (sheet.right - sheet.left),
                                   bottom - y.share(point.y) * (bottom - top)});
        const Series::Dots dots = chart.series[i].dots;
        if (dots == Series::Dots::always || (dots == Series::Dots::few && line.points.size() <= 30))
            for (const Point &point : line.points) sheet.add(Dot{point, dot_radius_px, line.paint});
        sheet.add(std::move(line));
    }
    sheet.y = bottom + 46;
    sheet.note(chart.note);
    return sheet.finish(chart.title);
}

}  // namespace charts
