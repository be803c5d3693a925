// Colours and fonts of charts: one table for all writers.
#pragma once

#include <array>

#include "samples/charts/drawing.h"

namespace charts
{

struct Colour {
    unsigned char red, green, blue;
};
struct Theme {
    std::array<Colour, theme_inks> inks;
};
extern const Theme light, dark;

// Distinct in hue and in brightness, legible on both grounds.
extern const std::array<Colour, series_colours> series_palette;

Colour colour_of(const Paint &paint, const Theme &theme);

struct Lettering {
    double size_px;
    bool bold;
    Ink ink;
};
Lettering lettering(Face face);

constexpr const char *font_family = "DejaVu Sans";

// Approximate width of a text, for layout only; no writer depends on it.
double width_of(const std::string &text, Face face);

// Lengths of stroke and gap for a line of this width; empty for solid ones.
std::vector<double> dashes_of(Dash dash, double width);

}  // namespace charts
