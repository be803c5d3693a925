#include "samples/charts/bars.h"

#include <algorithm>

#include "samples/charts/frame.h"

namespace charts
{
namespace
{

constexpr double left_px = 64;

// The number over a bar: significant digits only, because there is little room.
std::string shown(double value) { return number_text(value, value < 0.995 ? 2 : value < 9.95 ? 1 : 0); }

double largest(const Panel &panel)
{
    double most = 0;
    for (const auto &group : panel.values)
        for (const auto &cluster : group)
            for (const double value : cluster) most = std::max(most, value);
    return most;
}

void legend(Sheet &sheet, const BarChart &chart)
{
    std::vector<Sheet::Swatch> swatches;
    for (size_t c = 0; c < chart.colours.size(); ++c) swatches.push_back({chart.colours[c], series(c)});
    for (const Cluster &cluster : chart.panels.front().clusters)
        if (!cluster.name.empty()) swatches.push_back({cluster.name, {Ink::text, 0}, cluster.fill});
    sheet.legend(swatches);
}

void bars(Sheet &sheet, const BarChart &chart, const Panel &panel, const AxisScale &axis_scale, double top)
{
    const double floor = top + panel.height_px, each = static_cast<double>(chart.colours.size());
    const double room = (sheet.right - sheet.left) / static_cast<double>(chart.groups.size());
    const double clusters = static_cast<double>(panel.clusters.size());
    // A group has half a bar free between its clusters, and at least one and a half on either side.
    const double wide = std::min(34.0, room / (clusters * each + 0.5 * (clusters - 1) + 3));
    for (size_t g = 0; g < chart.groups.size(); ++g) {
        const double middle = sheet.left + room * (static_cast<double>(g) + 0.5);
        double x = middle - wide * (clusters * each + 0.5 * (clusters - 1)) / 2;
        for (size_t k = 0; k < panel.clusters.size(); ++k, x += wide / 2)
            for (size_t c = 0; c < chart.colours.size(); ++c, x += wide) {
                const double value = panel.values[g][k][c];
                if (value < 0) continue;
                const double height = axis_scale.share(value) * panel.height_px;
                sheet.add(Box{{x + 1, floor - height},
                              wide - 2,
                              std::max(height, 0.5),
                              series(c),
                              series(c),
                              panel.clusters[k].fill});
                sheet.add(Label{{x + wide / 2, floor - height - 4}, shown(value), Face::value, Anchor::middle});
            }
        sheet.add(Label{{middle, floor + 18}, chart.groups[g].name, Face::group, Anchor::middle});
        sheet.add(Label{{middle, floor + 34}, chart.groups[g].detail, Face::detail, Anchor::middle});
    }
}

}  // namespace

Drawing drawing_of(const BarChart &chart)
{
    Sheet sheet(left_px);
    sheet.head(chart.title, chart.subtitle);
    legend(sheet, chart);
    for (const Panel &panel : chart.panels) {
        sheet.add(Label{{sheet.left, sheet.y + 16}, panel.title, Face::panel});
        const double top = sheet.y + 34;
        const AxisScale axis_scale = axis_scale_of(Scale::linear, 0, largest(panel), 6, Zero::always);
        sheet.upright(axis_scale, top, top + panel.height_px, panel.unit);
        bars(sheet, chart, panel, axis_scale, top);
        sheet.y = top + panel.height_px + 46;
    }
    for (const std::string &note : chart.notes) sheet.note(note);
    return sheet.finish(chart.title);
}

}  // namespace charts
