#include "lib/math/hsb.h"

#include <algorithm>
#include <cmath>

namespace claque::math
{

void hsb_to_rgb(double hue_deg, double saturation, double brightness, double out_rgb[3])
{
    const double s = std::clamp(saturation, 0.0, 1.0), b = std::clamp(brightness, 0.0, 1.0);
    const double turn = hue_deg / 360 - std::floor(hue_deg / 360);
    // Each channel is full for a third of the circle about its own hue and falls off over a sixth on both sides.
    for (int channel = 0; channel < 3; ++channel) {
        double away = std::fabs(turn - channel / 3.0);
        if (away > 0.5) away = 1 - away;
        const double share = std::clamp(2 - 6 * away, 0.0, 1.0);
        out_rgb[channel] = b * (1 - s * (1 - share));
    }
}

void rgb_to_hsb(const double rgb[3], double out_hsb[3])
{
    const double high = std::max({rgb[0], rgb[1], rgb[2]}), span = high - std::min({rgb[0], rgb[1], rgb[2]});
    const int largest = rgb[0] == high ? 0 : rgb[1] == high ? 1 : 2;
    const double sixths = span > 0 ? 2 * largest + (rgb[(largest + 1) % 3] - rgb[(largest + 2) % 3]) / span : 0;
    out_hsb[0] = 60 * (sixths < 0 ? sixths + 6 : sixths);
    out_hsb[1] = high > 0 ? span / high : 0;
    out_hsb[2] = high;
}

Rgb8 rgb8_of(const double rgb[3])
{
    const auto byte = [](double x) { return static_cast<uint8_t>(std::floor(std::clamp(x, 0.0, 1.0) * 255 + 0.5)); };
    return {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])};
}

double lerp_hue(double min_deg, double max_deg, double u)
{
    const double width = max_deg - min_deg + (min_deg > max_deg ? 360 : 0);
    const double hue = min_deg + u * width;
    return hue >= 360 ? hue - 360 : hue;
}

}  // namespace claque::math
