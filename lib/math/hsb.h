// Hue, saturation and brightness: the space in which the colours of individuals are chosen (S2 5).
#pragma once

#include <cstdint>

namespace claque::math
{

struct Rgb8 {
    uint8_t r, g, b;
};

// Hue in degrees (any, wrapped), saturation and brightness in [0, 1] (clamped).
void hsb_to_rgb(double hue_deg, double saturation, double brightness, double out_rgb[3]);
void rgb_to_hsb(const double rgb[3], double out_hsb[3]);  // hue [0, 360); 0 for greys
Rgb8 rgb8_of(const double rgb[3]);                        // rounded to the nearest of 256, clamped

// A hue between two, ascending from min_deg; it passes 360 if min_deg > max_deg. u in [0, 1).
double lerp_hue(double min_deg, double max_deg, double u);

}  // namespace claque::math
