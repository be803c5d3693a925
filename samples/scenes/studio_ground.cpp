#include "samples/scenes/studio_ground.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/sky.h"

namespace scenes
{

void lay_studio_ground(Geometry &ground, double x, double y, double z, double half_m, double fade_m)
{
    constexpr Rgb near = {0.60f, 0.59f, 0.57f}, far = Sky::backdrop;
    constexpr int cells = 24;
    // Cells grow outwards, so that the fade is smooth near and cheap far away.
    const auto line = [&](int i) { return half_m * std::pow(2.0 * i / cells - 1, 3); };
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const double u = line(column), v = line(row);
            const double t = std::min(1.0, std::sqrt(u * u + v * v) / fade_m);
            const float k = static_cast<float>(t * t * (3 - 2 * t));
            ground.add({static_cast<float>(x + u), static_cast<float>(y), static_cast<float>(z + v)}, {0, 1, 0}, 0, 0,
                       {near.r + (far.r - near.r) * k, near.g + (far.g - near.g) * k, near.b + (far.b - near.b) * k});
        }
    for (uint32_t row = 0; row < cells; ++row)
        for (uint32_t column = 0; column < cells; ++column) {
            const uint32_t a = row * (cells + 1) + column, below = a + cells + 1;
            ground.triangle(a, below, below + 1);
            ground.triangle(a, below + 1, a + 1);
        }
}

}  // namespace scenes
