// Grass, crops, a street and water.
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/town/canvas.h"
#include "samples/scenes/town/pictures.h"

namespace scenes::town
{
namespace
{

Rgb grey(double tone) { return {static_cast<float>(tone), static_cast<float>(tone), static_cast<float>(tone)}; }

// Stones in staggered rows: the distance of a point to a joint, and the stone that it is on.
struct Stone {
    double to_joint;  // in widths of a stone
    uint64_t number;
};
Stone stone_at(uint64_t seed, double x, double y, int across)  // x and y in stones; repeats after `across` of them
{
    const double row = std::floor(y);
    const uint64_t number = static_cast<uint64_t>(row);
    const double shifted = x + random_unit(seed, number, Purpose::row);
    const double column = std::floor(shifted);
    const uint64_t wrapped = static_cast<uint64_t>(static_cast<int>(column) % across);
    const double fx = shifted - column, fy = y - row;
    return {std::min({fx, 1 - fx, fy, 1 - fy}), number * 512 + wrapped};
}

}  // namespace

Image land(uint64_t seed)
{
    const RepeatingNoise broad(seed + 30, 5, 5), tufts(seed + 31, 40, 40), blades(seed + 32, 256, 200);
    const RepeatingNoise straw(seed + 33, 16, 16);
    return painted(512, [&](double u, double v) {
        const double tone =
            0.80 + 0.16 * (broad(u, v) - 0.5) + 0.24 * (tufts(u, v) - 0.5) + 0.30 * (blades(u, v) - 0.5);
        const double dry = smooth_step((straw(u, v) - 0.62) / 0.3) * 0.10;
        return blend(grey(tone), {1.0f, 0.92f, 0.75f}, dry);
    });
}

Image furrows(uint64_t seed)
{
    constexpr int rows = 16;
    const RepeatingNoise wobble(seed + 40, 6, 6), growth(seed + 41, 128, 64), broad(seed + 42, 4, 4);
    return painted(512, [&](double u, double v) {
        const double at = v * rows + 0.25 * (wobble(u, v) - 0.5);
        const double ridge = 0.5 + 0.5 * std::sin(two_pi * at);
        const double tone = 0.72 + 0.18 * ridge + 0.20 * (growth(u, v) - 0.5) + 0.12 * (broad(u, v) - 0.5);
        return blend({0.55f, 0.47f, 0.38f}, grey(tone + 0.05), 0.55 + 0.45 * smooth_step(ridge * 1.6));
    });
}

Image cobbles(uint64_t seed)
{
    constexpr int sets = 48, slabs = 10;
    const RepeatingNoise dirt(seed + 50, 7, 5), fine(seed + 51, 256, 256), tracks(seed + 52, 3, 32);
    constexpr double kerb = (1 - roadway_share) / 2, kerb_wide = 0.022;
    return painted(512, [&](double u, double v) {
        const double from_side = std::min(v, 1 - v), grain = 0.07 * (fine(u, v) - 0.5) + 0.10 * (dirt(u, v) - 0.5);
        if (from_side < kerb - kerb_wide) {  // slabs of the pavement
            const Stone s = stone_at(seed + 53, u * slabs, v * slabs * 1.3, slabs);
            const double joint = 0.72 + 0.28 * smooth_step(s.to_joint / 0.05);
            const double tone = (0.80 + 0.08 * (random_unit(seed, s.number, Purpose::tone) - 0.5) + grain) * joint;
            return Rgb{static_cast<float>(tone), static_cast<float>(tone * 0.975), static_cast<float>(tone * 0.93)};
        }
        if (from_side < kerb) {
            const double along = u * slabs - std::floor(u * slabs);
            return grey((0.90 + grain) * (0.7 + 0.3 * smooth_step(std::min(along, 1 - along) / 0.03)));
        }
        const Stone s = stone_at(seed + 54, u * sets, v * sets, sets);
        const double round = 0.62 + 0.38 * smooth_step(s.to_joint / 0.22);
        const double gutter = 0.80 + 0.20 * smooth_step((from_side - kerb) / 0.05);
        const double worn = 1 + 0.10 * (tracks(u, v) - 0.5);
        const double tone =
            (0.64 + 0.16 * (random_unit(seed, s.number, Purpose::tone) - 0.5) + grain) * round * gutter * worn;
        return Rgb{static_cast<float>(tone * 1.01), static_cast<float>(tone), static_cast<float>(tone * 0.98)};
    });
}

Image water(uint64_t seed)
{
    const RepeatingNoise broad(seed + 60, 5, 6), ripples(seed + 61, 20, 56), fine(seed + 62, 64, 128);
    return painted(256, [&](double u, double v) {
        const double light =
            0.72 + 0.16 * (broad(u, v) - 0.5) + 0.16 * (ripples(u, v) - 0.5) + 0.10 * (fine(u, v) - 0.5);
        const double glint = smooth_step((ripples(u, v) * fine(u, v) - 0.62) / 0.2);
        return blend(grey(light), {1, 1, 1}, 0.6 * glint);
    });
}

}  // namespace scenes::town
