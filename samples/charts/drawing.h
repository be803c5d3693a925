// A chart as a list of marks, independent of SVG and PNG. Units are CSS pixels, y down.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace charts
{

// Inks that follow the reader's light or dark theme, and the colours of the series, which do not.
enum class Ink { text, quiet, ground, edge, grid, axis, series };
constexpr size_t theme_inks = static_cast<size_t>(Ink::series);
constexpr size_t series_colours = 8;

struct Paint {
    Ink ink = Ink::text;
    size_t series = 0;  // of Ink::series
};
inline Paint series(size_t i) { return {Ink::series, i % series_colours}; }

enum class Fill { solid, hatched, dotted };
enum class Dash { solid, dashed, dotted };
enum class Face { title, panel, group, plain, detail, note, value };
enum class Anchor { start, middle, end };
enum class Turn { level, upwards };

struct Point {
    double x, y;
};
struct Box {
    Point at;
    double width, height;
    Paint paint, rim;
    Fill fill = Fill::solid;
    double corner = 0;
};
struct Line {
    std::vector<Point> points;
    Paint paint;
    double width = 1;
    Dash dash = Dash::solid;
};
struct Dot {
    Point at;
    double radius;
    Paint paint;
};
struct Label {
    Point at;  // on the base line
    std::string text;
    Face face = Face::plain;
    Anchor anchor = Anchor::start;
    Turn turn = Turn::level;
};
using Mark = std::variant<Box, Line, Dot, Label>;

struct Drawing {
    int width_px, height_px;
    std::string title;
    std::vector<Mark> marks;
};

// Both give the same bytes for the same drawing. SVG follows the reader's theme on a ground of its own; pixels use the
// light theme. Text is in DejaVu Sans.
std::string svg_of(const Drawing &drawing);

struct Pixels {
    int width, height;
    std::vector<unsigned char> rgb;
};
// Throws scenes::Failure.
Pixels pixels_of(const Drawing &drawing, double pixels_per_px);

}  // namespace charts
