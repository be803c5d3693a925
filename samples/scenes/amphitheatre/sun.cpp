#include "samples/scenes/amphitheatre/sun.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr double latitude = 41.89 * radians, declination = 22 * radians, long_axis = 112.5 * radians;
constexpr double first_hour = 5.5, last_hour = 18.5;

Rgb mix(Rgb a, Rgb b, double share)
{
    const float t = static_cast<float>(share);
    return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
}

}  // namespace

Daylight daylight_at(double hour)
{
    const double angle = (std::clamp(hour, first_hour, last_hour) - 12) * 15 * radians;
    const double up =
        std::sin(latitude) * std::sin(declination) + std::cos(latitude) * std::cos(declination) * std::cos(angle);
    const double east = -std::cos(declination) * std::sin(angle);
    const double north =
        std::cos(latitude) * std::sin(declination) - std::sin(latitude) * std::cos(declination) * std::cos(angle);
    Daylight light;
    // Along the long axis, and along the short one, which points a quarter turn further by the compass.
    light.to_sun = {static_cast<float>(east * std::sin(long_axis) + north * std::cos(long_axis)),
                    static_cast<float>(up),
                    static_cast<float>(east * std::cos(long_axis) - north * std::sin(long_axis))};
    const double height = std::clamp((up - 0.05) / 0.6, 0.0, 1.0);
    light.sun = mix({0.86f, 0.52f, 0.27f}, {0.74f, 0.69f, 0.60f}, std::sqrt(height));
    light.sky = mix({0.43f, 0.41f, 0.43f}, {0.42f, 0.44f, 0.48f}, height);
    light.bounce = mix({0.17f, 0.12f, 0.09f}, {0.21f, 0.18f, 0.14f}, height);
    return light;
}

}  // namespace scenes::amphitheatre
