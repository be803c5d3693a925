// A chart as SVG, in colours that follow the reader's dark or light theme.
#include <cstdio>

#include "samples/charts/drawing.h"
#include "samples/charts/theme.h"

namespace charts
{
namespace
{

constexpr const char *ink_names[theme_inks] = {"text", "quiet", "ground", "edge", "grid", "axis"};
constexpr const char *face_names[] = {"title", "panel", "group", "plain", "detail", "note", "value"};
constexpr const char *anchor_names[] = {"start", "middle", "end"};

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

std::string px(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

std::string hex(const Colour &c)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", c.red, c.green, c.blue);
    return text;
}

// ` what="colour"`, or a class that the theme colours.
std::string painted(const char *what, const Paint &paint)
{
    if (paint.ink == Ink::series) return " " + std::string(what) + "=\"" + hex(colour_of(paint, light)) + "\"";
    return " class=\"" + std::string(what) + "-" + ink_names[static_cast<size_t>(paint.ink)] + "\"";
}

std::string pattern_name(Fill fill, const Paint &paint)
{
    return (fill == Fill::hatched ? "hatched-" : "dotted-") +
           (paint.ink == Ink::series ? std::to_string(paint.series) : ink_names[static_cast<size_t>(paint.ink)]);
}

struct Writer {
    std::string text;

    void operator()(const Box &b)
    {
        text += "<rect x=\"" + px(b.at.x) + "\" y=\"" + px(b.at.y) + "\" width=\"" + px(b.width) + "\" height=\"" +
                px(b.height) + "\"" + (b.corner > 0 ? " rx=\"" + px(b.corner) + "\"" : "");
        if (b.paint.ink == Ink::series || b.fill != Fill::solid) {
            text += b.fill == Fill::solid ? painted("fill", b.paint)
                                          : " fill=\"url(#" + pattern_name(b.fill, b.paint) + ")\"";
            text += painted("stroke", b.rim);
        } else {
            text += " class=\"fill-" + std::string(ink_names[static_cast<size_t>(b.paint.ink)]) + " stroke-" +
                    ink_names[static_cast<size_t>(b.rim.ink)] + "\"";
        }
        text += "/>\n";
    }
    void operator()(const Line &l)
    {
        text += "<path d=\"";
        for (size_t i = 0; i < l.points.size(); ++i)
            text += (i == 0 ? "M" : "L") + px(l.points[i].x) + " " + px(l.points[i].y);
        text += "\" fill=\"none\"" + painted("stroke", l.paint);
        if (l.width != 1) text += " stroke-width=\"" + px(l.width) + "\" stroke-linejoin=\"round\"";
        std::string dashes;
        for (const double length : dashes_of(l.dash, l.width)) dashes += (dashes.empty() ? "" : " ") + px(length);
        if (!dashes.empty()) text += " stroke-dasharray=\"" + dashes + "\"";
        text += "/>\n";
    }
    void operator()(const Dot &d)
    {
        text += "<circle cx=\"" + px(d.at.x) + "\" cy=\"" + px(d.at.y) + "\" r=\"" + px(d.radius) + "\"" +
                painted("fill", d.paint) + "/>\n";
    }
    void operator()(const Label &l)
    {
        const std::string x = px(l.at.x), y = px(l.at.y);
        text += "<text x=\"" + x + "\" y=\"" + y + "\" class=\"" + face_names[static_cast<size_t>(l.face)] + "\"";
        if (l.anchor != Anchor::start)
            text += std::string(" text-anchor=\"") + anchor_names[static_cast<size_t>(l.anchor)] + "\"";
        if (l.turn == Turn::upwards) text += " transform=\"rotate(-90 " + x + " " + y + ")\"";
        text += ">" + escaped(l.text) + "</text>\n";
    }
};

std::string colours_of(const Theme &theme)
{
    std::string css;
    for (size_t i = 0; i < theme_inks; ++i) {
        const std::string name = ink_names[i], colour = hex(theme.inks[i]);
        css += ".fill-" + name + " { fill: " + colour + "; } .stroke-" + name + " { stroke: " + colour + "; }\n";
    }
    for (size_t f = 0; f < std::size(face_names); ++f)
        css += "." + std::string(face_names[f]) +
               " { fill: " + hex(colour_of({lettering(static_cast<Face>(f)).ink, 0}, theme)) + "; }\n";
    return css;
}

std::string style()
{
    std::string css = "<style>\ntext { font-family: '" + std::string(font_family) + "', Verdana, sans-serif; }\n";
    for (size_t f = 0; f < std::size(face_names); ++f) {
        const Lettering how = lettering(static_cast<Face>(f));
        css += "." + std::string(face_names[f]) + " { font-size: " + px(how.size_px) + "px;" +
               (how.bold ? " font-weight: bold;" : "") + " }\n";
    }
    return css + colours_of(light) + "@media (prefers-color-scheme: dark) {\n" + colours_of(dark) + "}\n</style>\n";
}

std::string patterns_of(const Paint &paint)
{
    const std::string fill = painted("fill", paint);
    return "<pattern id=\"" + pattern_name(Fill::hatched, paint) +
           "\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><rect "
           "width=\"2\" height=\"5\"" +
           fill + "/></pattern>\n<pattern id=\"" + pattern_name(Fill::dotted, paint) +
           "\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\"><circle cx=\"2.5\" cy=\"2.5\" r=\"1.4\"" +
           fill + "/></pattern>\n";
}

// Patterns of the paints that some box uses.
std::string patterns(const Drawing &drawing)
{
    std::string text;
    bool text_ink = false, wanted[series_colours] = {};
    for (const Mark &mark : drawing.marks)
        if (const Box *box = std::get_if<Box>(&mark); box && box->fill != Fill::solid)
            (box->paint.ink == Ink::series ? wanted[box->paint.series] : text_ink) = true;
    if (text_ink) text += patterns_of({Ink::text, 0});
    for (size_t c = 0; c < series_colours; ++c)
        if (wanted[c]) text += patterns_of(series(c));
    return text.empty() ? "" : "<defs>\n" + text + "</defs>\n";
}

}  // namespace

std::string svg_of(const Drawing &drawing)
{
    Writer writer;
    for (const Mark &mark : drawing.marks) std::visit(writer, mark);
    const std::string height = std::to_string(drawing.height_px), width = std::to_string(drawing.width_px);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height + "\" role=\"img\">\n<title>" + escaped(drawing.title) +
           "</title>\n" + style() + patterns(drawing) + writer.text + "</svg>\n";
}

}  // namespace charts
