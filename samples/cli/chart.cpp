#include "samples/cli/chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cli
{
namespace
{

constexpr int width_px = 960, left_px = 64, right_px = 20;
constexpr int head_px = 58, legend_px = 30, panel_head_px = 34, group_foot_px = 46, note_px = 18;
constexpr const char *palette[] = {"#8b929c", "#2f80c9", "#e08a1e", "#3d9a5f", "#a35bb5"};

std::string escaped(const std::string &text)
{
    std::string safe;
    for (const char c : text) {
        if (c == '&') safe += "&amp;";
        else if (c == '<') safe += "&lt;";
        else if (c == '>') safe += "&gt;";
        else if (c == '"') safe += "&quot;";
        else safe += c;
    }
    return safe;
}

std::string number(double value, int digits)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string px(double value) { return number(value, 1); }

// Over a bar: as many digits as say something, in little room.
std::string shown(double value) { return number(value, value < 0.995 ? 2 : value < 9.95 ? 1 : 0); }

std::string text_at(double x, double y, const char *kind, const std::string &text)
{
    return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" class=\"" + kind + "\">" + escaped(text) + "</text>\n";
}

// The name of a pattern: of a colour, or of the text's for the legend.
std::string pattern(Fill fill, const std::string &of) { return (fill == Fill::hatched ? "hatched" : "dotted") + of; }

std::string fill_of(Fill fill, size_t colour)
{
    const size_t c = colour % std::size(palette);
    return fill == Fill::solid ? palette[c] : "url(#" + pattern(fill, std::to_string(c)) + ")";
}

std::string bar(double x, double y, double width, double height, Fill fill, size_t colour)
{
    return "<rect x=\"" + px(x) + "\" y=\"" + px(y) + "\" width=\"" + px(width) + "\" height=\"" +
           px(std::max(height, 0.5)) + "\" fill=\"" + fill_of(fill, colour) + "\" stroke=\"" +
           palette[colour % std::size(palette)] + "\"/>\n";
}

std::string patterns_of(const std::string &name, const std::string &paint)
{
    return "<pattern id=\"" + pattern(Fill::hatched, name) +
           "\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><rect "
           "width=\"2\" height=\"5\" " +
           paint + "/></pattern>\n<pattern id=\"" + pattern(Fill::dotted, name) +
           "\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\"><circle cx=\"2.5\" cy=\"2.5\" r=\"1.4\" " +
           paint + "/></pattern>\n";
}

std::string patterns()
{
    std::string text = "<defs>\n" + patterns_of("ink", "class=\"ink\"");
    for (size_t c = 0; c < std::size(palette); ++c)
        text += patterns_of(std::to_string(c), "fill=\"" + std::string(palette[c]) + "\"");
    return text + "</defs>\n";
}

constexpr const char *style =
    "<style>\n"
    "text { font: 12px 'DejaVu Sans', Verdana, sans-serif; fill: #24292f; }\n"
    ".title { font-size: 17px; font-weight: bold; }\n"
    ".panel { font-size: 13px; font-weight: bold; }\n"
    ".group { font-size: 13px; text-anchor: middle; }\n"
    ".detail { text-anchor: middle; fill: #57606a; }\n"
    ".quiet { fill: #57606a; font-size: 11px; }\n"
    ".tick { text-anchor: end; fill: #57606a; }\n"
    ".value { font-size: 10px; text-anchor: middle; }\n"
    ".unit { text-anchor: middle; fill: #57606a; }\n"
    ".ground { fill: #ffffff; stroke: #d0d7de; }\n"
    ".grid { stroke: #d8dee4; }\n"
    ".axis { stroke: #57606a; }\n"
    ".ink { fill: #24292f; }\n"
    ".rim { stroke: #24292f; }\n"
    "@media (prefers-color-scheme: dark) {\n"
    "text { fill: #e6edf3; }\n"
    ".detail, .quiet, .tick, .unit { fill: #a9b3be; }\n"
    ".ground { fill: #161b22; stroke: #3d444d; }\n"
    ".grid { stroke: #30363d; }\n"
    ".axis { stroke: #a9b3be; }\n"
    ".ink { fill: #e6edf3; }\n"
    ".rim { stroke: #e6edf3; }\n"
    "}\n"
    "</style>\n";

std::string legend(const Chart &chart, double y)
{
    std::string text;
    double x = left_px;
    const auto name = [&](const std::string &swatch, const std::string &words) {
        text += swatch + text_at(x + 20, y + 10, "legend", words);
        x += 34 + 7.4 * static_cast<double>(words.size());
    };
    for (size_t c = 0; c < chart.colours.size(); ++c) name(bar(x, y, 14, 11, Fill::solid, c), chart.colours[c]);
    x += 16;
    for (const Cluster &cluster : chart.panels.front().clusters) {
        const std::string fill =
            cluster.fill == Fill::solid ? "ink rim\"" : "rim\" fill=\"url(#" + pattern(cluster.fill, "ink") + ")\"";
        name("<rect x=\"" + px(x) + "\" y=\"" + px(y) + "\" width=\"14\" height=\"11\" class=\"" + fill + "/>\n",
             cluster.name);
    }
    return text;
}

struct Scale {
    double step, top, floor_y, px_per_unit;
    double y(double value) const { return floor_y - value * px_per_unit; }
};

Scale scale_of(const Panel &panel, double floor_y)
{
    double largest = 0;
    for (const auto &group : panel.values)
        for (const auto &cluster : group)
            for (const double value : cluster) largest = std::max(largest, value);
    const double step = tick_step(largest, 6);
    const double top = step * std::max(1.0, std::ceil(largest / step));
    return {step, top, floor_y, panel.height_px / top};
}

std::string grid(const Panel &panel, const Scale &scale)
{
    std::string text;
    const int ticks = static_cast<int>(std::lround(scale.top / scale.step));
    const int digits = scale.step >= 1 ? 0 : scale.step >= 0.1 ? 1 : 2;
    for (int i = 0; i <= ticks; ++i) {
        const double value = i * scale.step;
        text += "<path d=\"M" + px(left_px) + " " + px(scale.y(value)) + "H" + px(width_px - right_px) + "\" class=\"" +
                (i == 0 ? "axis" : "grid") + "\"/>\n" +
                text_at(left_px - 8, scale.y(value) + 4, "tick", number(value, digits));
    }
    const std::string middle = px(scale.y(scale.top / 2));
    return text + "<text x=\"18\" y=\"" + middle + "\" class=\"unit\" transform=\"rotate(-90 18 " + middle + ")\">" +
           escaped(panel.unit) + "</text>\n";
}

std::string bars(const Chart &chart, const Panel &panel, const Scale &scale)
{
    std::string text;
    const double room = static_cast<double>(width_px - left_px - right_px) / static_cast<double>(chart.groups.size());
    const double clusters = static_cast<double>(panel.clusters.size()),
                 each = static_cast<double>(chart.colours.size());
    // A group has half a bar free between its clusters, and at least one and a half on either side.
    const double wide = std::min(34.0, room / (clusters * each + 0.5 * (clusters - 1) + 3));
    for (size_t g = 0; g < chart.groups.size(); ++g) {
        double x =
            left_px + room * (static_cast<double>(g) + 0.5) - wide * (clusters * each + 0.5 * (clusters - 1)) / 2;
        for (size_t k = 0; k < panel.clusters.size(); ++k, x += wide / 2)
            for (size_t c = 0; c < chart.colours.size(); ++c, x += wide) {
                const double value = panel.values[g][k][c];
                if (value < 0) continue;
                text +=
                    bar(x + 1, scale.y(value), wide - 2, scale.floor_y - scale.y(value), panel.clusters[k].fill, c) +
                    text_at(x + wide / 2, scale.y(value) - 4, "value", shown(value));
            }
    }
    return text;
}

std::string group_names(const Chart &chart, double y)
{
    std::string text;
    const double room = static_cast<double>(width_px - left_px - right_px) / static_cast<double>(chart.groups.size());
    for (size_t g = 0; g < chart.groups.size(); ++g) {
        const double x = left_px + room * (static_cast<double>(g) + 0.5);
        text +=
            text_at(x, y + 18, "group", chart.groups[g].name) + text_at(x, y + 34, "detail", chart.groups[g].detail);
    }
    return text;
}

}  // namespace

double tick_step(double largest, int most)
{
    double step = 0.01;
    for (int i = 0; largest / step > most && i < 60; ++i) step *= i % 3 == 1 ? 2.5 : 2;  // 1, 2, 5, 10 ...
    return step;
}

std::string svg_of(const Chart &chart)
{
    std::string body = text_at(left_px, 28, "title", chart.title) + text_at(left_px, 46, "quiet", chart.subtitle) +
                       legend(chart, head_px + 4);
    double y = head_px + legend_px;
    for (const Panel &panel : chart.panels) {
        body += text_at(left_px, y + 16, "panel", panel.title);
        y += panel_head_px + panel.height_px;
        const Scale scale = scale_of(panel, y);
        body += grid(panel, scale) + bars(chart, panel, scale) + group_names(chart, y);
        y += group_foot_px;
    }
    for (const std::string &note : chart.notes) body += text_at(left_px, y += note_px, "quiet", note);
    const std::string height = std::to_string(static_cast<int>(y) + 16), width = std::to_string(width_px);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height + "\" role=\"img\">\n<title>" + escaped(chart.title) +
           "</title>\n" + style + patterns() + "<rect x=\"0.5\" y=\"0.5\" width=\"" + std::to_string(width_px - 1) +
           "\" height=\"" + std::to_string(static_cast<int>(y) + 15) + "\" rx=\"6\" class=\"ground\"/>\n" + body +
           "</svg>\n";
}

}  // namespace cli
