#include "tests/unit/track/stairs.h"

#include <algorithm>
#include <cmath>

namespace claque::test
{

double Stairs::tread(double z) const
{
    return z < first_m ? 0 : rise_m * (std::floor((std::min(z, last_m - 1e-6) - first_m) / run_m) + 1);
}

double Stairs::ramp(double z) const
{
    return std::clamp((z - first_m + run_m / 2) * rise_m / run_m, 0.0, tread(last_m));
}

std::vector<track::Point> climb(const Stairs &stairs, double speed, bool down)
{
    const double length_m = 12;
    const auto z = [&](double t) { return down ? length_m - speed * t : speed * t; };
    auto points = points_of(20, length_m / speed, [&](double t) { return glm::dvec2(0, z(t)); });
    for (track::Point &point : points) point.position.y = stairs.ramp(point.position.z);
    return points;
}

track::BuildSettings settings_for(Stairs &stairs)
{
    track::BuildSettings settings;
    settings.smooth_s = 0.3;
    settings.ground = [](void *user, const double point[3]) { return static_cast<Stairs *>(user)->tread(point[2]); };
    settings.ground_user = &stairs;
    return settings;
}

}  // namespace claque::test
