// OKLab (Ottosson 2020): a perceptual space, from display colours (sRGB). It is used instead of CIELAB because blues
// keep their hue and it needs cube roots only.
#pragma once

namespace claque::math
{

// The positive n-th root of x, 2 <= n <= 5; 0 for x <= 0. Uses +, *, / alone, so it is the same on every processor.
double nth_root(double x, int n);

// rgb: each [0, 1]. out: lightness [0, 1], green to red, blue to yellow.
void oklab_of(const double rgb[3], double out[3]);

// Derivatives of OKLab by hue (per degree), saturation and brightness: three vectors. At the six hues where the
// derivative jumps it is the one towards higher hues. brightness > 0.
struct OklabSlopes {
    double hue[3], saturation[3], brightness[3];
};
OklabSlopes oklab_slopes(double hue_deg, double saturation, double brightness);

}  // namespace claque::math
