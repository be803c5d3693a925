#include "lib/math/oklab.h"

#include <cmath>

#include "lib/math/hsb.h"

namespace claque::math
{

namespace
{

// The matrix from linear sRGB to cone responses, and the one from their cube roots to OKLab.
constexpr double cones_of[3][3] = {{0.4122214708, 0.5363325363, 0.0514459929},
                                   {0.2119034982, 0.6806995451, 0.1073969566},
                                   {0.0883024619, 0.2817188376, 0.6299787005}};
constexpr double lab_of[3][3] = {{0.2104542553, 0.7936177850, -0.0040720468},
                                 {1.9779984951, -2.4285922050, 0.4505937099},
                                 {0.0259040371, 0.7827717662, -0.8086757660}};

void times(const double matrix[3][3], const double x[3], double out[3])
{
    for (int row = 0; row < 3; ++row) out[row] = matrix[row][0] * x[0] + matrix[row][1] * x[1] + matrix[row][2] * x[2];
}

// A value of the sRGB curve and its derivative.
struct Light {
    double value, slope;
};
Light light_of(double channel)
{
    if (channel <= 0.04045) return {channel / 12.92, 1 / 12.92};
    const double t = (channel + 0.055) / 1.055, value = t * t * nth_root(t * t, 5);  // t to the 2.4
    return {value, 2.4 / 1.055 * value / t};
}

// The value of a channel in the pure hue, and its derivative per degree: see hsb_to_rgb.
Light share_of(double hue_deg, int channel)
{
    double away = hue_deg / 360 - channel / 3.0;
    away -= std::floor(away + 0.5);  // [-1/2, 1/2)
    const double share = 2 - 6 * std::fabs(away);
    const bool rises = away < 0;
    if (share > 1 || (share == 1 && rises)) return {1, 0};
    if (share < 0 || (share == 0 && !rises)) return {0, 0};
    return {share, (rises ? 6.0 : -6.0) / 360};
}

}  // namespace

double nth_root(double x, int n)
{
    if (!(x > 0)) return 0;
    int exponent = 0;
    std::frexp(x, &exponent);
    const int whole = exponent >= 0 ? exponent / n : -((n - 1 - exponent) / n), rest = exponent - whole * n;
    double y =
        // off by a quarter at most, which six steps of Newton's method reduce to 0
        std::ldexp(1 + double(rest) / n, whole);
    for (int step = 0; step < 6; ++step) {
        double power = 1;
        for (int k = 1; k < n; ++k) power *= y;
        y += (x / power - y) / n;
    }
    return y;
}

void oklab_of(const double rgb[3], double out[3])
{
    double light[3], cones[3];
    for (int k = 0; k < 3; ++k) light[k] = light_of(rgb[k]).value;
    times(cones_of, light, cones);
    for (double &cone : cones) cone = nth_root(cone, 3);
    times(lab_of, cones, out);
}

OklabSlopes oklab_slopes(double hue_deg, double saturation, double brightness)
{
    double light[3], by_hue[3], by_saturation[3], by_brightness[3], cones[3];
    for (int k = 0; k < 3; ++k) {
        const Light share = share_of(hue_deg, k);
        const double pale = 1 - saturation * (1 - share.value);
        const Light channel = light_of(brightness * pale);
        light[k] = channel.value;
        by_hue[k] = channel.slope * brightness * saturation * share.slope;
        by_saturation[k] = channel.slope * brightness * (share.value - 1);
        by_brightness[k] = channel.slope * pale;
    }
    times(cones_of, light, cones);
    const auto through = [&](const double light_slope[3], double out[3]) {
        double slope[3];
        times(cones_of, light_slope, slope);
        for (int k = 0; k < 3; ++k) {
            const double cube_root = nth_root(cones[k], 3);
            slope[k] /= 3 * cube_root * cube_root;
        }
        times(lab_of, slope, out);
    };
    OklabSlopes slopes;
    through(by_hue, slopes.hue);
    through(by_saturation, slopes.saturation);
    through(by_brightness, slopes.brightness);
    return slopes;
}

}  // namespace claque::math
