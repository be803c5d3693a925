#include "samples/scenes/odeon/stair_stone.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"

namespace scenes
{
namespace
{

constexpr double landing_m = 0.5;  // of the level floor before and behind: a foot reaches over both
constexpr double storey_m = 1;

}  // namespace

StairStone::StairStone(const Theatre &theatre)
{
    for (const Gangway &gangway : theatre.gangways)
        flights_.push_back({gangway.at_deg, gangway.width_m / 2, treads_of(theatre, gangway)});
}

double StairStone::height_m(const double point[3]) const
{
    const double radius = std::hypot(point[0], point[2]), angle = std::atan2(point[0], -point[2]);
    double y = NAN, nearest_m = landing_m;
    for (const Flight &flight : flights_) {
        const std::vector<Tread> &treads = flight.treads;
        // A landing ends where another flight begins.
        const double beside_m = std::max(treads.front().from_m - radius, radius - treads.back().to_m);
        if (!(std::max(beside_m, 0.0) < nearest_m)) continue;
        if (std::abs(angle - flight.at_deg * radians) * radius > flight.half_width_m) continue;
        const auto ends_before = [](const Tread &tread, double at) { return tread.to_m <= at; };
        auto tread = std::lower_bound(treads.begin(), treads.end(), radius, ends_before);
        if (tread == treads.end()) --tread;
        if (!(std::abs(tread->y - point[1]) < storey_m)) continue;
        y = tread->y, nearest_m = std::max(beside_m, 0.0);
    }
    return y;
}

}  // namespace scenes
