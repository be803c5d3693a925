// Where people on tracks look, and how they hold their shoulders.
#include <algorithm>
#include <cmath>

#include "lib/math/trig.h"
#include "lib/track/piece.h"

namespace claque::track
{

namespace
{

constexpr double whole_turn_rad = 2 * math::pi;
// The gaze is ahead of the heading by the mean of these, so that corners of the heading do not jerk the head.
constexpr double first_ahead_s = 0.35, last_ahead_s = 0.75;
constexpr double max_gaze_rad = 1.1;  // that a neck turns; half of that is reached with half an angle more
// A passing person is noticed from `far_m` on, and the shoulders turn fully at `near_m`, from centre to centre.
constexpr double far_m = 1.0, near_m = 0.5, shoulder_rad = 0.5, shoulder_half_s = 0.65, min_half_s = 0.35;

constexpr double border_fade_s = 0.6;  // in which what the piece before showed besides fades

double nearest(double angle_rad) { return angle_rad - whole_turn_rad * std::floor(angle_rad / whole_turn_rad + 0.5); }

double heading_at(const Track &track, double time_s)
{
    double at = (time_s - track.start_s) * track.rate_hz;
    const size_t own = track.samples.size();
    const double last = std::min(track.length_s * track.rate_hz, double(own - 1)) + double(track.ahead.size());
    at = at > 0 ? at < last ? at : last : 0;
    const size_t i = std::min(static_cast<size_t>(at), own + track.ahead.size() - 2);
    const auto heading = [&](size_t k) { return k < own ? track.samples[k].heading : track.ahead[k - own]; };
    const uint16_t from = heading(i), to = heading(i + 1);
    const int16_t step = static_cast<int16_t>(static_cast<uint16_t>(to - from));
    return (double(from) + double(step) * (at - double(i))) / 65536 * whole_turn_rad;
}

// Nearly the angle itself where it is small, and never more than `most`.
double softly_limited(double angle, double most) { return angle / std::sqrt(1 + angle * angle / (most * most)); }

double shoulders_at(const Track &track, double gone_s)
{
    const Array<uint32_t> &index = track.first_shoulders;
    if (index.empty() || !(gone_s > 0)) return 0;
    const size_t second = static_cast<size_t>(std::fmin(gone_s, double(index.size() - 1)));
    for (uint32_t i = index[second]; i < track.shoulders.size(); ++i) {
        const ShoulderTurn &turn = track.shoulders[i];
        const double away = std::fabs(gone_s - double(turn.at_s)), half = double(turn.half_s);
        if (away < half) return double(turn.turn_rad) * eased(1 - away / half);
        if (double(turn.at_s) > gone_s) return 0;
    }
    return 0;
}

}  // namespace

pose::UpperTarget upper_at(const Track &track, const State &state, double time_s) noexcept
{
    pose::UpperTarget target;
    target.upper = &track.locomotion->upper;
    const double first = nearest(heading_at(track, time_s + first_ahead_s) - state.heading_rad);
    const double last = nearest(heading_at(track, time_s + last_ahead_s) - state.heading_rad);
    target.gaze_rad = static_cast<float>(softly_limited(0.5 * (first + last), max_gaze_rad));
    target.torso_rad = static_cast<float>(shoulders_at(track, time_s - track.start_s));
    const double gone_s = time_s - track.start_s;
    if (track.previous_hash == 0 || !(gone_s < border_fade_s)) return target;
    const float left = static_cast<float>(1 - eased(gone_s / border_fade_s));
    target.gaze_rad += left * track.upper_swing.gaze_rad, target.torso_rad += left * track.upper_swing.torso_rad;
    return target;
}

void make_shoulders(const BuildSettings &settings, const FinePath &path, Track &out)
{
    out.shoulders.clear();
    for (const Passing &passing : settings.passings) {
        // A turn begins before its passing and ends after it, maybe in another piece.
        const double gone_s = passing.time_s - out.start_s, in_path_s = passing.time_s - path.start_s;
        if (!(gone_s > -shoulder_half_s && gone_s < out.length_s + shoulder_half_s)) continue;
        if (!(in_path_s >= 0)) continue;
        const uint32_t i = std::min(static_cast<uint32_t>(in_path_s * path.hz + 0.5), path.count() - 1);
        if (path.stands[i]) continue;
        const glm::dvec3 other = passing.position * settings.metres_per_unit - out.origin_m;
        const double x = other.x - path.x[i], z = other.z - path.z[i], distance = std::sqrt(x * x + z * z);
        const double close = eased((far_m - distance) / (far_m - near_m));
        // The shoulder on the side of the other goes back; one ahead or behind is not passed.
        const double left = x * math::cos(path.heading[i]) - z * math::sin(path.heading[i]);
        const double turn = distance > 0 ? shoulder_rad * close * left / distance : 0;
        if (std::fabs(turn) < 0.03) continue;
        ShoulderTurn next{static_cast<float>(gone_s), static_cast<float>(shoulder_half_s), static_cast<float>(turn)};
        if (!out.shoulders.empty()) {
            ShoulderTurn &before = out.shoulders.back();
            const float apart = next.at_s - before.at_s;
            if (apart < 2 * static_cast<float>(min_half_s)) {
                if (std::fabs(next.turn_rad) <= std::fabs(before.turn_rad)) continue;
                next.half_s = std::min(next.half_s, before.half_s);
                before = next;
                continue;
            }
            // Two in short sequence share the time between them.
            if (apart < before.half_s + next.half_s) {
                next.half_s = std::min(next.half_s, 0.499f * apart);
                before.half_s = std::min(before.half_s, 0.499f * apart);
            }
        }
        out.shoulders.push_back(next);
    }
}

void make_ahead(const FinePath &path, Track &out)
{
    out.ahead.clear();
    const double every = path.hz / out.rate_hz;
    for (uint32_t k = 1; k <= static_cast<uint32_t>(std::ceil(last_ahead_s * out.rate_hz)); ++k) {
        const uint32_t i = path.last + static_cast<uint32_t>(k * every + 0.5);
        if (i >= path.count()) return;
        const double turns = path.heading[i] / whole_turn_rad;
        out.ahead.push_back(static_cast<uint16_t>(static_cast<int64_t>(std::floor(turns * 65536 + 0.5))));
    }
}

void join_upper(const Track &previous, Track &out)
{
    const State state = state_at(out, out.start_s);
    out.upper_swing = {};
    const pose::UpperTarget shown = upper_at(previous, state, out.start_s), own = upper_at(out, state, out.start_s);
    out.upper_swing.gaze_rad = shown.gaze_rad - own.gaze_rad;
    out.upper_swing.torso_rad = shown.torso_rad - own.torso_rad;
}

}  // namespace claque::track
