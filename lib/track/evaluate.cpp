// A track at a time: positions on a cubic curve through the samples, angles along the shorter way. While both
// neighbours stand, nothing moves.
#include <cmath>

#include <glm/common.hpp>

#include "lib/math/trig.h"
#include "lib/track/track.h"

namespace claque::track
{

namespace
{

constexpr double turn_rad = 2 * math::pi;
constexpr double turning_reach = 0.3;  // of a leg's length
constexpr double clear_share = 0.35;   // of a swing, in which a foot gets to the height of its next tread
constexpr double level_again_s = 0.3;  // where no plant says more of the ground

// The sample before a time, and how far it is to the next.
struct Place {
    uint32_t first = 0;
    double part = 0;
};

Place place_of(const Track &track, double time_s)
{
    double at = (time_s - track.start_s) * track.rate_hz;
    const double last = track.length_s * track.rate_hz;
    if (!(at > 0)) at = 0;
    if (at > last) at = last;
    Place place;
    place.first = static_cast<uint32_t>(at);
    const uint32_t end = static_cast<uint32_t>(track.samples.size());
    if (place.first + 2 > end) place.first = end - 2;
    place.part = at - place.first;
    return place;
}

bool stands(const Sample &sample) { return sample.flags & stands_flag; }

struct Metres {
    double x, y, z;
};

Metres point_of(const Track &track, const Sample &sample)
{
    return {double(sample.x) * place_step_m, double(sample.height) * track.height_step_m,
            double(sample.z) * place_step_m};
}

double cubic(double a, double b, double slope_a, double slope_b, double t)
{
    const double rise = b - a;
    return a + t * (slope_a + t * (3 * rise - 2 * slope_a - slope_b + t * (slope_a + slope_b - 2 * rise)));
}

// Its slope.
double cubic_slope(double a, double b, double slope_a, double slope_b, double t)
{
    const double rise = b - a;
    return slope_a + t * (2 * (3 * rise - 2 * slope_a - slope_b) + 3 * t * (slope_a + slope_b - 2 * rise));
}

// The slope at a sample, for one step of the grid.
Metres slope_at(const Track &track, uint32_t i)
{
    if (stands(track.samples[i])) return {0, 0, 0};
    const uint32_t last = static_cast<uint32_t>(track.samples.size()) - 1;
    const uint32_t before = i > 0 ? i - 1 : 0, after = i < last ? i + 1 : last;
    const Metres a = point_of(track, track.samples[before]), b = point_of(track, track.samples[after]);
    const double steps = after - before;
    return {(b.x - a.x) / steps, (b.y - a.y) / steps, (b.z - a.z) / steps};
}

Metres point_at(const Track &track, const Place &place)
{
    const Sample &from = track.samples[place.first], &to = track.samples[place.first + 1];
    const Metres a = point_of(track, from);
    if (place.part == 0 || (stands(from) && stands(to))) return a;
    const Metres b = point_of(track, to), m = slope_at(track, place.first), n = slope_at(track, place.first + 1);
    return {cubic(a.x, b.x, m.x, n.x, place.part), cubic(a.y, b.y, m.y, n.y, place.part),
            cubic(a.z, b.z, m.z, n.z, place.part)};
}

// Along the shorter way round, in turns.
double angle_at(uint16_t from, uint16_t to, double part)
{
    const int16_t step = static_cast<int16_t>(static_cast<uint16_t>(to - from));
    return (double(from) + double(step) * part) / 65536;
}

glm::dvec3 world_of(const Track &track, const Metres &p)
{
    return (track.origin_m + glm::dvec3(p.x, p.y + track.min_height_m, p.z)) / track.metres_per_unit;
}

double shorter(double angle_rad) { return angle_rad - turn_rad * std::floor(angle_rad / turn_rad + 0.5); }

// Of the ground below a foot over the body's own place.
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
            height_of(plant, body_y)};
}

Correction at_end(const Plant &plant, double heading_rad, double body_y)
{
    return {double(plant.end_x), double(plant.end_z), shorter(double(plant.heading_rad) - heading_rad),
            height_of(plant, body_y)};
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

uint64_t Track::bytes() const
{
    uint64_t sum = sizeof(Track) + samples.capacity() * sizeof(Sample);
    for (int f = 0; f < 2; ++f)
        sum += plants[f].capacity() * sizeof(Plant) + first_plants[f].capacity() * sizeof(uint32_t);
    return sum + shoulders.capacity() * sizeof(ShoulderTurn) + first_shoulders.capacity() * sizeof(uint32_t) +
           (ahead.capacity() + sinks.capacity()) * sizeof(uint16_t);
}

bool is_present(const Track &track, double time_s) noexcept
{
    return time_s >= track.start_s && time_s <= track.start_s + track.length_s;
}

glm::dvec3 position_at(const Track &track, double time_s) noexcept
{
    return world_of(track, point_at(track, place_of(track, time_s)));
}

Motion motion_at(const Track &track, double time_s) noexcept
{
    const Place place = place_of(track, time_s);
    const Sample &from = track.samples[place.first], &to = track.samples[place.first + 1];
    Motion motion;
    motion.present = is_present(track, time_s);
    motion.position = world_of(track, point_at(track, place));
    motion.heading_rad = turn_rad * angle_at(from.heading, to.heading, place.part);
    if (!motion.present || (stands(from) && stands(to))) return motion;
    const Metres a = point_of(track, from), b = point_of(track, to);
    const Metres m = slope_at(track, place.first), n = slope_at(track, place.first + 1);
    const double x = cubic_slope(a.x, b.x, m.x, n.x, place.part), z = cubic_slope(a.z, b.z, m.z, n.z, place.part);
    const double reach = turning_reach * double(track.locomotion->leg_length) * track.scale;
    const double turn = turn_rad * std::fabs(angle_at(0, static_cast<uint16_t>(to.heading - from.heading), 1));
    motion.speed = std::sqrt(x * x + z * z) * track.rate_hz / track.metres_per_unit;
    motion.limb_speed = motion.speed + turn * reach * track.rate_hz / track.metres_per_unit;
    return motion;
}

// The speed on a cubic curve is a quadratic one, which its three Bezier points bound.
double top_speed_of(const Track &track)
{
    double most = 0;
    const auto add = [&most](double x, double y, double z) { most = std::fmax(most, x * x + y * y + z * z); };
    for (uint32_t i = 0; i + 1 < track.samples.size(); ++i) {
        const Metres a = point_of(track, track.samples[i]), b = point_of(track, track.samples[i + 1]);
        if (stands(track.samples[i]) && stands(track.samples[i + 1])) {
            if (a.x != b.x || a.y != b.y || a.z != b.z) return HUGE_VAL;  // only a file can hold a jump
            continue;
        }
        const Metres m = slope_at(track, i), n = slope_at(track, i + 1);
        add(m.x, m.y, m.z), add(n.x, n.y, n.z);
        add(3 * (b.x - a.x) - m.x - n.x, 3 * (b.y - a.y) - m.y - n.y, 3 * (b.z - a.z) - m.z - n.z);
    }
    return std::sqrt(most) * track.rate_hz / track.metres_per_unit * (1 + 1e-9);
}

// A cubic curve stays in the box of its four Bezier points.
Box reach_of(const Track &track)
{
    glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
    const auto add = [&](const Metres &from, const Metres &slope, double part) {
        const glm::dvec3 p(from.x + part * slope.x, from.y + part * slope.y, from.z + part * slope.z);
        low = glm::min(low, p), high = glm::max(high, p);
    };
    for (uint32_t i = 0; i < track.samples.size(); ++i) {
        const Metres p = point_of(track, track.samples[i]), m = slope_at(track, i);
        add(p, m, 0), add(p, m, 1.0 / 3), add(p, m, -1.0 / 3);
    }
    const glm::dvec3 rounding = 1e-9 * (high - low);
    const auto world = [&](const glm::dvec3 &p) { return world_of(track, {p.x, p.y, p.z}); };
    return {world(low - rounding), world(high + rounding)};
}

State state_at(const Track &track, double time_s) noexcept
{
    const Place place = place_of(track, time_s);
    const Sample &from = track.samples[place.first], &to = track.samples[place.first + 1];
    State state;
    state.position = world_of(track, point_at(track, place));
    state.heading_rad = turn_rad * angle_at(from.heading, to.heading, place.part);
    state.phase = angle_at(from.phase, to.phase, place.part);
    state.gait =
        static_cast<float>((double(from.gait) + (double(to.gait) - double(from.gait)) * place.part) / gait_unit);
    const double turn = turn_of(from.flags), next_turn = turn_of(to.flags);
    state.turn = static_cast<float>((turn + (next_turn - turn) * place.part) / turn_unit);
    state.stands = stands(from) && stands(to);
    state.idle = idle_of(from.flags);
    return state;
}

Correction correction_at(const Track &track, const State &state, int foot, double time_s) noexcept
{
    const Array<Plant> &plants = track.plants[foot];
    const double gone_s = time_s - track.start_s;
    const uint32_t i = plant_at(track, foot, gone_s);
    Correction out;
    const bool before = i > 0, after = i < plants.size();
    const double body_y = height_of(track, state), heading = state.heading_rad;
    if (before && after) {
        const double begin = double(plants[i - 1].end_s), end = double(plants[i].begin_s);
        const double part = eased((gone_s - begin) / (end - begin));
        const Correction a = at_end(plants[i - 1], heading, body_y), b = at_begin(plants[i], heading, body_y);
        out = {a.x + (b.x - a.x) * part, a.z + (b.z - a.z) * part, a.turn_rad + (b.turn_rad - a.turn_rad) * part,
               raised(a.y, b.y, (gone_s - begin) / (end - begin))};
    } else if (before) {
        out = at_end(plants[i - 1], heading, body_y);
        out.y *= 1 - eased((gone_s - double(plants[i - 1].end_s)) / level_again_s);
    } else if (after) {
        out = at_begin(plants[i], heading, body_y);
        out.y *= 1 - eased((double(plants[i].begin_s) - gone_s) / level_again_s);
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
    if (i < plants.size() && double(plants[i].begin_s) <= gone_s) {
        const Plant &plant = plants[i];
        const glm::dvec3 body = state.position * track.metres_per_unit - track.origin_m;
        target.planted = true;
        set(double(plant.x) - body.x, double(plant.z) - body.z);
        correction.turn_rad = shorter(double(plant.heading_rad) - state.heading_rad);
        correction.y = height_of(plant, height_of(track, state));
        const double edge = std::fmin(gone_s - double(plant.begin_s), double(plant.end_s) - gone_s);
        target.ground = static_cast<float>(eased(edge / landing_s));
    } else {
        correction = correction_at(track, state, foot, time_s);
        set(correction.x, correction.z);
    }
    const double turn = std::fmax(-max_foot_turn_rad, std::fmin(max_foot_turn_rad, correction.turn_rad));
    target.turn_rad = static_cast<float>(turn);
    target.y = static_cast<float>(correction.y / track.scale);
    target.sink = static_cast<float>(sink_at(track, time_s) / track.scale);
    return target;
}

}  // namespace claque::track
