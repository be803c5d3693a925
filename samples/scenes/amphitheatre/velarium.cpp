#include "samples/scenes/amphitheatre/velarium.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr double top_m = 54.5, drop_m = 7.5, sag_m = 1.4;  // at the masts; to the ring; between
constexpr double least_m = 5, most_m = 33;                 // of a strip's reach
constexpr double soft_m = 0.7;                             // half the width of a shadow's edge

}  // namespace

Velarium::Velarium(const Plan &plan, const Daylight &light) : plan_(plan), to_sun_(light.to_sun) {}

double Velarium::reach_of(int bay) const
{
    const Spot spot = plan_.oval().at(plan_.turn_of(bay), building_m);
    const double sx = static_cast<double>(to_sun_.x), sz = static_cast<double>(to_sun_.z);
    const double level = std::sqrt(sx * sx + sz * sz);
    if (level < 1e-6) return least_m;
    const double away = std::sqrt(spot.x * spot.x + spot.z * spot.z);
    const double towards = (spot.x * sx + spot.z * sz) / (away * level);  // 1 on the sun's side
    const double share = std::clamp((towards + 0.25) / 0.85, 0.0, 1.0);
    return least_m + (most_m - least_m) * share * share * (3 - 2 * share);
}

double Velarium::height_at(double out) const
{
    const double in = std::clamp((mast_m - out) / (mast_m - ring_m), 0.0, 1.0);
    return top_m - drop_m * in - 4 * sag_m * in * (1 - in);
}

double Velarium::passes(Vec3 at) const
{
    const double up = static_cast<double>(to_sun_.y);
    const double x = static_cast<double>(at.x), y = static_cast<double>(at.y), z = static_cast<double>(at.z);
    // The ray to the sun rises; the surface of the ropes is nearly level, so that it is met once.
    double low = 0, high = (top_m + 2 - y) / up;
    if (!(high > 0)) return 1;
    Bearing met = {};
    for (int i = 0; i < 14; ++i) {
        const double s = (low + high) / 2;
        met = plan_.oval().bearing(x + s * static_cast<double>(to_sun_.x), z + s * static_cast<double>(to_sun_.z));
        if (y + s * up < height_at(met.out)) low = s;
        else high = s;
    }
    if (met.out > mast_m) return 1;
    const double bay = plan_.oval().length(met.turn, building_m) / plan_.oval().perimeter(building_m) * bay_count;
    const double reach = reach_of(static_cast<int>(std::floor(bay + 0.5)) % bay_count);
    const double inside = (met.out - (mast_m - reach)) / (2 * soft_m) + 0.5;
    return 1 - (1 - through_linen) * std::clamp(inside, 0.0, 1.0);
}

Rgb Velarium::dye_of(int bay)
{
    // Lucretius 4.75: yellow, red and rust-purple awnings over great theatres.
    constexpr Rgb dyes[] = {{0.93f, 0.72f, 0.30f}, {0.90f, 0.84f, 0.70f}, {0.74f, 0.25f, 0.17f}, {0.90f, 0.84f, 0.70f},
                            {0.93f, 0.72f, 0.30f}, {0.90f, 0.84f, 0.70f}, {0.55f, 0.22f, 0.28f}, {0.90f, 0.84f, 0.70f}};
    return dyes[static_cast<size_t>(bay) % 8];
}

}  // namespace scenes::amphitheatre
