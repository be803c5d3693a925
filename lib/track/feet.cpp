// The feet of a track at a time: held where they stand, in the air from one place to the next.
#include <cmath>

#include "lib/math/trig.h"
#include "lib/track/build.h"

namespace claque::track
{

namespace
{

constexpr double clear_share = 0.35;   // of a swing, in which a foot gets to the height of its next tread
constexpr double level_again_s = 0.3;  // where no plant says more of the ground
constexpr double half_step = 0.45;     // of a leg's length, that a foot is before or behind the body

double shorter(double angle_rad) { return nearest_turn(angle_rad, 0); }

// The height of the ground below a foot, from the body's own place.
double height_of(const Plant &plant, double body_y) { return std::isfinite(plant.y) ? double(plant.y) - body_y : 0; }

// The height of the body, metres from the track's origin.
double height_of(const Track &track, const State &state)
{
    return state.position.y * track.metres_per_unit - track.origin_m.y;
}

// The correction of a foot in the air goes from that at the end of one plant to that at the beginning of the next.
Correction at_begin(const Plant &plant, double heading_rad, double body_y)
{
    return {double(plant.begin_x), double(plant.begin_z), shorter(double(plant.heading_rad) - heading_rad),
            height_of(plant, body_y), double(plant.slope)};
}

Correction at_end(const Plant &plant, double heading_rad, double body_y)
{
    return {double(plant.end_x), double(plant.end_z), shorter(double(plant.heading_rad) - heading_rad),
            height_of(plant, body_y), double(plant.slope)};
}

// A foot clears the edges of treads: it goes up early and down late.
double raised(double from, double to, double part)
{
    const double gone = to > from ? part / clear_share : (part - 1 + clear_share) / clear_share;
    return from + (to - from) * eased(gone);
}

// The first plant that has not ended at a time.
uint32_t plant_at(const Track &track, int foot, double gone_s)
{
    const Array<Plant> &plants = track.plants[foot];
    const Array<uint32_t> &index = track.first_plants[foot];
    const size_t second = gone_s > 0 ? static_cast<size_t>(std::fmin(gone_s, double(index.size()))) : 0;
    uint32_t i = second < index.size() ? index[second] : static_cast<uint32_t>(plants.size());
    while (i < plants.size() && double(plants[i].end_s) < gone_s) ++i;
    return i;
}

}  // namespace

Correction correction_at(const Track &track, const State &state, int foot, double time_s) noexcept
{
    const Array<Plant> &plants = track.plants[foot];
    const double gone_s = time_s - track.start_s;
    const uint32_t i = plant_at(track, foot, gone_s);
    Correction out;
    // For a foot that is ahead of the body or behind it on a slope.
    const double step_m = half_step * double(track.locomotion->leg_length) * track.scale;
    const auto room = [step_m](double slope) { return std::fabs(slope) * step_m; };
    const bool before = i > 0, after = i < plants.size();
    const double body_y = height_of(track, state), heading = state.heading_rad;
    if (before && after) {
        const double begin = double(plants[i - 1].end_s), end = double(plants[i].begin_s);
        const double part = eased((gone_s - begin) / (end - begin));
        const Correction a = at_end(plants[i - 1], heading, body_y), b = at_begin(plants[i], heading, body_y);
        out = {a.x + (b.x - a.x) * part, a.z + (b.z - a.z) * part, a.turn_rad + (b.turn_rad - a.turn_rad) * part,
               raised(a.y, b.y, (gone_s - begin) / (end - begin)), a.slope + (b.slope - a.slope) * part};
    } else if (before) {
        out = at_end(plants[i - 1], heading, body_y);
        out.y += (room(out.slope) - out.y) * eased((gone_s - double(plants[i - 1].end_s)) / level_again_s);
    } else if (after) {
        out = at_begin(plants[i], heading, body_y);
        out.y += (room(out.slope) - out.y) * eased((double(plants[i].begin_s) - gone_s) / level_again_s);
    }
    const Swing &swing = track.swings[foot];
    if (gone_s < double(swing.until_s)) {
        const double left = 1 - eased(gone_s / double(swing.until_s));
        out.x += double(swing.x) * left, out.z += double(swing.z) * left, out.turn_rad += double(swing.turn_rad) * left;
        out.y += double(swing.y) * left;
    }
    return out;
}

pose::FootTarget foot_at(const Track &track, const State &state, int foot, double time_s) noexcept
{
    const Array<Plant> &plants = track.plants[foot];
    const double gone_s = time_s - track.start_s;
    const uint32_t i = plant_at(track, foot, gone_s);
    pose::FootTarget target;
    target.leg = &track.locomotion->legs[foot];
    const double c = math::cos(state.heading_rad), s = math::sin(state.heading_rad);
    // From the world, relative to the body, to model space.
    const auto set = [&](double x, double z) {
        target.x = static_cast<float>((x * c - z * s) / track.scale);
        target.z = static_cast<float>((x * s + z * c) / track.scale);
    };
    Correction correction;
    double clear = clear_m;
    if (i < plants.size() && double(plants[i].begin_s) <= gone_s) {
        const Plant &plant = plants[i];
        const glm::dvec3 body = state.position * track.metres_per_unit - track.origin_m;
        target.planted = true;
        set(double(plant.x) - body.x, double(plant.z) - body.z);
        correction.turn_rad = shorter(double(plant.heading_rad) - state.heading_rad);
        correction.y = height_of(plant, height_of(track, state)), correction.slope = double(plant.slope);
        const double edge = std::fmin(gone_s - double(plant.begin_s), double(plant.end_s) - gone_s);
        target.ground = static_cast<float>(eased(edge / landing_s));
    } else {
        correction = correction_at(track, state, foot, time_s);
        set(correction.x, correction.z);
        const double since = i > 0 ? gone_s - double(plants[i - 1].end_s) : rise_s;
        const double until = i < plants.size() ? double(plants[i].begin_s) - gone_s : rise_s;
        clear += mid_swing_m * eased(std::fmin(since, until) / rise_s);
    }
    target.clear = static_cast<float>(clear / track.scale);
    const double turn = std::fmax(-max_foot_turn_rad, std::fmin(max_foot_turn_rad, correction.turn_rad));
    target.turn_rad = static_cast<float>(turn);
    target.y = static_cast<float>(correction.y / track.scale);
    target.slope = static_cast<float>(correction.slope);
    target.sink = static_cast<float>(sink_at(track, time_s) / track.scale);
    return target;
}

}  // namespace claque::track
