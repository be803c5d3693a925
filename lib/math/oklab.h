// OKLab (Ottosson 2020): a space in which equal distances look about equally large, of colours as a display takes them (sRGB).
// Taken in place of CIELAB because blues keep their hue in it, and because cube roots are all that it needs.
#pragma once

namespace claque::math
{

// The positive n-th root of x, 2 <= n <= 5; 0 for x <= 0. By +, *, / alone, so the same on every processor.
double nth_root(double x, int n);

// rgb: each [0, 1]. out: lightness [0, 1], green to red, blue to yellow.
void oklab_of(const double rgb[3], double out[3]);

// How OKLab changes with hue (a degree), saturation and brightness: three vectors. At the six hues where the change breaks
// off, that towards higher hues. brightness > 0.
struct OklabSlopes {
    double hue[3], saturation[3], brightness[3];
};
OklabSlopes oklab_slopes(double hue_deg, double saturation, double brightness);

}  // namespace claque::math
