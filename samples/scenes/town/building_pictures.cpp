// Roof tiles and leaves.
#include <cmath>

#include "samples/scenes/town/canvas.h"
#include "samples/scenes/town/pictures.h"

namespace scenes::town
{

Image tiles(uint64_t seed)
{
    constexpr int courses = 12, across = 16;
    const RepeatingNoise moss(seed + 70, 5, 4), streaks(seed + 71, 48, 3), fine(seed + 72, 200, 200);
    return painted(512, [&](double u, double v) {
        const double row = std::floor(v * courses), up = v * courses - row;
        const double x = u * across + 0.5 * (static_cast<int>(row) % 2);
        const double column = std::floor(x), in = x - column;
        const uint64_t number =
            static_cast<uint64_t>(row) * 64 + static_cast<uint64_t>(static_cast<int>(column) % across);
        // Each tile is rounded at its end and shades the head of the next one, on which it lies.
        const double side = std::abs(in - 0.5) * 2, end = 0.16 * side * side;
        const double lip = smooth_step((up - end) / 0.10), under = 0.55 + 0.45 * smooth_step((1.0 - up) / 0.30);
        const double joint = 0.72 + 0.28 * smooth_step((1 - side) / 0.16);
        double tone = 0.86 + 0.20 * (random_unit(seed, number, Purpose::tone) - 0.5) + 0.12 * (streaks(u, v) - 0.5);
        tone += 0.10 * (fine(u, v) - 0.5);
        tone *= (0.58 + 0.42 * lip) * under * joint;
        const Rgb tile = {static_cast<float>(tone), static_cast<float>(tone * 0.985), static_cast<float>(tone * 0.97)};
        return blend(tile, {0.58f, 0.62f, 0.46f}, 0.35 * smooth_step((moss(u, v) - 0.66) / 0.25));
    });
}

Image leaves(uint64_t seed)
{
    const RepeatingNoise clumps(seed + 80, 9, 9), twigs(seed + 81, 28, 28), single(seed + 82, 90, 90);
    return painted(256, [&](double u, double v) {
        const double depth = 0.45 * clumps(u, v) + 0.33 * twigs(u, v) + 0.30 * single(u, v);
        const double tone = 0.46 + 0.66 * smooth_step((depth - 0.22) / 0.62);
        return Rgb{static_cast<float>(tone), static_cast<float>(tone), static_cast<float>(tone * 0.9)};
    });
}

}  // namespace scenes::town
