#include "samples/scenes/zone_inks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace scenes
{

Ink zone_ink(size_t zone)
{
    const double turn = 0.02 + 0.6180339887498949 * static_cast<double>(zone), hue = 6 * (turn - std::floor(turn));
    const double bright = zone % 2 == 0 ? 0.95 : 0.68;
    const auto channel = [&](double at) {
        const double away = std::abs(std::fmod(hue - at + 9, 6.0) - 3);
        return static_cast<uint8_t>(255 * bright * (0.25 + 0.75 * std::clamp(2 - away, 0.0, 1.0)) + 0.5);
    };
    return {channel(0), channel(2), channel(4)};
}

std::string hex_of(const Ink &ink)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", ink[0], ink[1], ink[2]);
    return text;
}

}  // namespace scenes
