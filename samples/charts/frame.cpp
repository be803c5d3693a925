#include "samples/charts/frame.h"

#include <algorithm>
#include <sstream>

#include "samples/charts/theme.h"

namespace charts
{

std::vector<std::string> lines_of(const std::string &text, Face face, double width)
{
    std::vector<std::string> lines;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (!lines.empty() && width_of(lines.back() + " " + word, face) <= width) lines.back() += " " + word;
        else lines.push_back(word);
    }
    return lines;
}

Sheet::Sheet(double left_px) : left(left_px), drawing_{sheet_width_px, 0, "", {}}
{
    add(Box{{0.5, 0.5}, sheet_width_px - 1.0, 0, {Ink::ground, 0}, {Ink::edge, 0}, Fill::solid, 6});
}

void Sheet::head(const std::string &title, const std::string &subtitle)
{
    y = 6;
    for (const std::string &line : lines_of(title, Face::title, right - left))
        add(Label{{left, y += 22}, line, Face::title});
    for (const std::string &line : lines_of(subtitle, Face::note, right - left))
        add(Label{{left, y += 18}, line, Face::note});
    y += 16;
}

void Sheet::note(const std::string &text)
{
    for (const std::string &line : lines_of(text, Face::note, right - left))
        add(Label{{left, y += 18}, line, Face::note});
}

void Sheet::legend(const std::vector<Swatch> &swatches)
{
    constexpr double gap = 16;
    const auto swatch_width = [](const Swatch &s) { return s.line_width > 0 ? 26.0 : 14.0; };
    const auto width = [&](const Swatch &s) { return swatch_width(s) + 6 + width_of(s.name, Face::plain) + gap; };
    double all = 0, widest = 0;
    for (const Swatch &s : swatches) {
        all += width(s);
        widest = std::max(widest, width(s));
    }
    // One row in the given order; several rows are aligned in columns.
    const double room = right - left + gap;
    const bool one_row = all <= room;
    double x = left;
    for (const Swatch &s : swatches) {
        const double wide = one_row ? width(s) : widest, swatch = swatch_width(s);
        if (x > left && x + wide > left + room) {
            x = left;
            y += 18;
        }
        if (s.line_width > 0) add(Line{{{x, y + 5.5}, {x + swatch, y + 5.5}}, s.paint, s.line_width, s.dash});
        else add(Box{{x, y}, swatch, 11, s.paint, s.paint, s.fill});
        add(Label{{x + swatch + 6, y + 10}, s.name, Face::plain});
        x += wide;
    }
    y += 26;
}

void Sheet::upright(const AxisScale &axis_scale, double top, double bottom, const std::string &title)
{
    for (const double tick : axis_scale.ticks) {
        const double at = bottom - axis_scale.share(tick) * (bottom - top);
        const bool ground = tick == axis_scale.from || tick == 0;
        add(Line{{{left, at}, {right, at}}, {ground ? Ink::axis : Ink::grid, 0}});
        add(Label{{left - 8, at + 4}, tick_text(axis_scale, tick), Face::detail, Anchor::end});
    }
    add(Label{{18, (top + bottom) / 2}, title, Face::detail, Anchor::middle, Turn::upwards});
}

Drawing Sheet::finish(const std::string &title)
{
    drawing_.title = title;
    drawing_.height_px = static_cast<int>(y) + 16;
    std::get<Box>(drawing_.marks.front()).height = drawing_.height_px - 1.0;
    return std::move(drawing_);
}

}  // namespace charts
