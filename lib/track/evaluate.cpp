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

}  // namespace claque::track
