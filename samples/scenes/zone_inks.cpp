#include "samples/scenes/zone_inks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace scenes
{

Ink ink_of(double hue, double saturation, double brightness)
{
    const double sixth = 6 * (hue - std::floor(hue));
    const auto channel = [&](double at) {
        const double away = std::abs(std::fmod(sixth - at + 9, 6.0) - 3);
        const double value = brightness * (1 - saturation + saturation * std::clamp(2 - away, 0.0, 1.0));
        return static_cast<uint8_t>(std::clamp(255 * value + 0.5, 0.0, 255.0));
    };
    return {channel(0), channel(2), channel(4)};
}

Ink zone_ink(size_t zone)
{
    return ink_of(0.02 + 0.6180339887498949 * static_cast<double>(zone), 0.75, zone % 2 == 0 ? 0.95 : 0.68);
}

std::string hex_of(const Ink &ink)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", ink[0], ink[1], ink[2]);
    return text;
}

}  // namespace scenes
