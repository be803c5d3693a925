#include "samples/scenes/everything/paint.h"

#include <cmath>

#include "samples/scenes/angles.h"

namespace scenes::everything
{
namespace
{

constexpr double middle = (image_px - 1) / 2.0;

// Darker towards the folds of cloth, which run upwards.
uint8_t fold(uint32_t x, uint32_t folds)
{
    return static_cast<uint8_t>(std::lround(222 + 33 * std::cos(two_pi * folds * x / image_px)));
}

Zone zone_at(uint32_t x, uint32_t y, Pattern pattern)
{
    if (y >= 36 && y < 41) return sash;
    if (pattern == Pattern::chequers) return y < 24 && (x / 8 + y / 8) % 2 == 0 ? trim : gown;
    const uint32_t tooth = x % 16 < 8 ? x % 8 : 7 - x % 8;
    return (y >= tooth + 4 && y < tooth + 12) || y >= 58 ? trim : gown;
}

}  // namespace

uint32_t key_of(Zone zone) { return 30 * (zone + 1); }

std::vector<uint8_t> gown_image(Pattern pattern)
{
    std::vector<uint8_t> out;
    for (uint32_t y = 0; y < image_px; ++y)
        for (uint32_t x = 0; x < image_px; ++x) {
            const uint8_t light = fold(x, pattern == Pattern::zigzag ? 8 : 4);
            out.insert(out.end(), {light, light, light, static_cast<uint8_t>(key_of(zone_at(x, y, pattern)))});
        }
    return out;
}

std::vector<uint8_t> cape_image()
{
    std::vector<uint8_t> out;
    for (uint32_t y = 0; y < image_px; ++y)
        for (uint32_t x = 0; x < image_px; ++x) {
            constexpr double radius = 4.5, row_px = 18;
            const double across = std::fabs(std::fabs(x - middle) - 16);
            const double up = std::fmod(y + row_px / 2, row_px) - row_px / 2;
            const bool hole = y > 5 && y < 50 && across * across + up * up < radius * radius;
            const uint8_t light = fold(x, 6);
            out.insert(out.end(), {light, light, light, static_cast<uint8_t>(hole ? 0 : 255)});
        }
    return out;
}

}  // namespace scenes::everything
