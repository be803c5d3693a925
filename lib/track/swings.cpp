// The feet of a piece at its border: plants of the piece before that hold on, and swings that go on.
#include <cmath>

#include "lib/track/piece.h"

namespace claque::track
{

namespace
{

constexpr double lonely_swing_s = 0.3;  // in which the rest of a swing fades whose end is not known

Plant moved(Plant plant, double seconds)
{
    plant.begin_s = static_cast<float>(double(plant.begin_s) - seconds);
    plant.end_s = static_cast<float>(double(plant.end_s) - seconds);
    return plant;
}

}  // namespace

CarriedFoot carried_foot(const Track &previous, int foot)
{
    CarriedFoot out;
    for (const Plant &plant : previous.plants[foot]) {
        const Plant now = moved(plant, previous.length_s);
        if (now.end_s < 0) {
            out.before = now, out.has_before = true;
        } else if (now.begin_s <= 0) {
            out.held = now, out.planted = true;
        } else {
            out.next = now, out.lands_soon = !out.planted && double(now.begin_s) <= landing_s;
            break;
        }
    }
    return out;
}

void join_swings(const Track &previous, Track &out)
{
    const State state = state_at(out, out.start_s);
    for (int f = 0; f < 2; ++f) {
        double until_s = lonely_swing_s;
        bool planted = false;
        for (const Plant &plant : out.plants[f]) {
            planted = planted || (plant.begin_s <= 0 && plant.end_s >= 0);
            if (!(plant.begin_s > 0)) continue;
            until_s = double(plant.begin_s);
            break;
        }
        out.swings[f] = {};
        if (planted) continue;
        const Correction shown = correction_at(previous, state, f, out.start_s);
        const Correction own = correction_at(out, state, f, out.start_s);
        out.swings[f].x = static_cast<float>(shown.x - own.x), out.swings[f].z = static_cast<float>(shown.z - own.z);
        out.swings[f].y = static_cast<float>(shown.y - own.y);
        out.climbs = out.climbs || out.swings[f].y != 0;
        out.swings[f].turn_rad = static_cast<float>(shown.turn_rad - own.turn_rad);
        out.swings[f].until_s = static_cast<float>(until_s);
    }
}

}  // namespace claque::track
