#include "lib/asset/hsb_ranges.h"

#include <algorithm>
#include <cmath>

namespace claque::asset
{

using model::HsbRange;

Hsb hsb_of(const std::array<float, 3> &c)
{
    const float high = std::max({c[0], c[1], c[2]}), low = std::min({c[0], c[1], c[2]}), span = high - low;
    Hsb out{0, high > 0 ? span / high : 0, high};
    if (span > 0) {
        const float sixth = high == c[0]   ? (c[1] - c[2]) / span
                            : high == c[1] ? (c[2] - c[0]) / span + 2
                                           : (c[0] - c[1]) / span + 4;
        out.hue_deg = 60 * (sixth < 0 ? sixth + 6 : sixth);
    }
    return out;
}

float on_circle(float degrees) { return degrees - 360 * std::floor(degrees / 360); }

HsbRange around(const Hsb &c, float hue_deg, float saturation, float brightness)
{
    const auto unit = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
    HsbRange out;
    out.hue_min_deg = on_circle(c.hue_deg - hue_deg);
    out.hue_max_deg = on_circle(c.hue_deg + hue_deg);
    out.saturation_min = unit(c.saturation - saturation);
    out.saturation_max = unit(c.saturation + saturation);
    out.brightness_min = unit(c.brightness - brightness);
    out.brightness_max = unit(c.brightness + brightness);
    return out;
}

HsbRange including(HsbRange range, const Hsb &c)
{
    range.saturation_min = std::min(range.saturation_min, c.saturation);
    range.saturation_max = std::max(range.saturation_max, c.saturation);
    range.brightness_min = std::min(range.brightness_min, c.brightness);
    range.brightness_max = std::max(range.brightness_max, c.brightness);
    const float width = on_circle(range.hue_max_deg - range.hue_min_deg);
    const float above = on_circle(c.hue_deg - range.hue_min_deg);
    if (c.saturation > 0 && above > width) {
        if (above - width < 360 - above) range.hue_max_deg = c.hue_deg;
        else range.hue_min_deg = c.hue_deg;
    }
    return range;
}

}  // namespace claque::asset
