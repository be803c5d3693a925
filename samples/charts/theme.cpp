#include "samples/charts/theme.h"

#include <cstring>

namespace charts
{

const Theme light = {{{{0x24, 0x29, 0x2f},
                       {0x57, 0x60, 0x6a},
                       {0xff, 0xff, 0xff},
                       {0xd0, 0xd7, 0xde},
                       {0xd8, 0xde, 0xe4},
                       {0x57, 0x60, 0x6a}}}};
const Theme dark = {{{{0xe6, 0xed, 0xf3},
                      {0xa9, 0xb3, 0xbe},
                      {0x16, 0x1b, 0x22},
                      {0x3d, 0x44, 0x4d},
                      {0x30, 0x36, 0x3d},
                      {0xa9, 0xb3, 0xbe}}}};

const std::array<Colour, series_colours> series_palette = {{{0x8b, 0x92, 0x9c},
                                                            {0x2f, 0x80, 0xc9},
                                                            {0xe0, 0x8a, 0x1e},
                                                            {0x3d, 0x9a, 0x5f},
                                                            {0xa3, 0x5b, 0xb5},
                                                            {0xd0, 0x45, 0x4c},
                                                            {0x1f, 0xa3, 0xa3},
                                                            {0x8f, 0x6a, 0x3a}}};

Colour colour_of(const Paint &paint, const Theme &theme)
{
    return paint.ink == Ink::series ? series_palette[paint.series % series_colours]
                                    : theme.inks[static_cast<size_t>(paint.ink)];
}

Lettering lettering(Face face)
{
    switch (face) {
        case Face::title:
            return {17, true, Ink::text};
        case Face::panel:
            return {13, true, Ink::text};
        case Face::group:
            return {13, false, Ink::text};
        case Face::plain:
            return {12, false, Ink::text};
        case Face::detail:
            return {12, false, Ink::quiet};
        case Face::note:
            return {11, false, Ink::quiet};
        case Face::value:
            return {10, false, Ink::text};
    }
    return {12, false, Ink::text};
}

namespace
{

// As a fraction of the font size, for DejaVu Sans.
double width_of(char c)
{
    const auto is_in = [c](const char *letters) { return std::strchr(letters, c) != nullptr; };
    if (is_in("ijlI'|.,:;! ")) return 0.32;
    if (is_in("ftr()[]-/\"")) return 0.42;
    if (is_in("mwMW%@")) return 0.95;
    if (is_in("ckrsvxyz")) return 0.55;
    return c >= 'A' && c <= 'Z' ? 0.70 : 0.62;
}

}  // namespace

double width_of(const std::string &text, Face face)
{
    double letters = 0;
    for (const char c : text)
        if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) letters += width_of(c);
    const Lettering how = lettering(face);
    return letters * how.size_px * (how.bold ? 1.12 : 1);
}

std::vector<double> dashes_of(Dash dash, double width)
{
    switch (dash) {
        case Dash::solid:
            return {};
        case Dash::dashed:
            return {3.5 * width, 2.5 * width};
        case Dash::dotted:
            return {width, 1.8 * width};
    }
    return {};
}

}  // namespace charts
