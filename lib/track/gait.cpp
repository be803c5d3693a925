// The share of each clip by speed, and the phase by the distance travelled: the foot on the ground then moves back as
// fast as the body goes forward. Slow people take short steps at nearly the pace of the walk.
#include <algorithm>
#include <cmath>

#include "lib/base/hash.h"
#include "lib/track/piece.h"

namespace claque::track
{

namespace
{

constexpr double min_gait = 0.08;                           // of a person that moves at all
constexpr double turn_step_m = 0.25, turn_stride_m = 0.08;  // that feet travel while the body turns by a radian
constexpr double fast_walk = 1.35;     // of the walk's own speed: from here on it is blended with the run
constexpr uint32_t ramp_samples = 18;  // in which the first step begins and the last one ends
constexpr double max_pace = 1.6;       // of a clip's own
// A person that turns faster than this without getting anywhere turns on the spot, by so much in a cycle.
constexpr double on_the_spot_m_s = 0.12, on_the_spot_rad_s = 0.1, turn_a_cycle_rad = 1.5;
constexpr double min_turning_pace = 0.7;  // of the clip's own
constexpr uint32_t turning_ramp = 10;     // samples

// Whether the clip that turns on the spot is shown instead of steps of the walk.
bool is_on_the_spot(const Locomotion &locomotion, const FinePath &path, uint32_t i)
{
    return !locomotion.turn_cells.empty() && path.speed[i] < on_the_spot_m_s;
}

// Metres a second that the feet travel, with `share` of the turn.
double travel(const Locomotion &locomotion, const FinePath &path, uint32_t i, double share)
{
    return path.speed[i] + (is_on_the_spot(locomotion, path, i) ? 0 : share * path.turn[i]);
}

double gait_of(const Locomotion &locomotion, double speed_m_s, double scale_m)
{
    const double walk = locomotion.walking_speed() * scale_m;
    if (speed_m_s < walk && locomotion.clips.slow != model::none) {
        const double slow = locomotion.slow_speed() * scale_m, gait = double(slow_gait);
        if (speed_m_s < slow) return std::max(min_gait, gait * speed_m_s / slow);
        return gait + (1 - gait) * (speed_m_s - slow) / (walk - slow);
    }
    if (speed_m_s < walk) return std::max(min_gait, speed_m_s / walk);
    if (locomotion.clips.run == model::none) return 1;
    const double from = fast_walk * walk, to = std::max(locomotion.running_speed() * scale_m, 1.2 * from);
    return 1 + std::min(1.0, std::max(0.0, (speed_m_s - from) / (to - from)));
}

// The phase at which a foot leaves the ground, in short steps.
double lift_of(const Locomotion &locomotion, int foot)
{
    constexpr uint32_t step = 2;
    for (uint32_t p = 0; p < phase_count; ++p)
        if (locomotion.cell(step, p).supports[foot] > 0 &&
            !(locomotion.cell(step, (p + 1) % phase_count).supports[foot] > 0))
            return double(p) / phase_count;
    return 0;
}

struct Run {
    uint32_t first, last;  // samples that do not stand
};

// Calls body(run) for each run of samples that move or turn.
template <class Body>
void for_moving(const FinePath &path, const Body &body)
{
    for (uint32_t i = 0; i < path.count(); ++i) {
        if (path.stands[i]) continue;
        Run run{i, i};
        while (run.last + 1 < path.count() && !path.stands[run.last + 1]) ++run.last;
        body(run);
        i = run.last;
    }
}

void set_gait(const Locomotion &locomotion, double scale_m, FinePath &path)
{
    path.gait.assign(path.count(), 0.0);
    for_moving(path, [&](Run run) {
        for (uint32_t i = run.first; i <= run.last; ++i)
            path.gait[i] = gait_of(locomotion, travel(locomotion, path, i, turn_stride_m), scale_m);
        smooth(path.gait, run.first, run.last, 12, Beyond::still);
        const bool starts = run.first > 0, ends = run.last + 1 < path.count();
        for (uint32_t i = run.first; i <= run.last; ++i) {
            const double in = starts ? eased(double(i - run.first + 1) / ramp_samples) : 1;
            const double out = ends ? eased(double(run.last - i + 1) / ramp_samples) : 1;
            path.gait[i] *= std::min(in, out);
        }
    });
}

void set_turning(const Locomotion &locomotion, FinePath &path)
{
    path.turning.assign(path.count(), 0.0);
    if (locomotion.turn_cells.empty()) return;
    for_moving(path, [&](Run run) {
        for (uint32_t i = run.first; i <= run.last; ++i)
            path.turning[i] = is_on_the_spot(locomotion, path, i) && path.turn[i] > on_the_spot_rad_s;
        smooth(path.turning, run.first, run.last, turning_ramp / 2, Beyond::still);
        const bool starts = run.first > 0, ends = run.last + 1 < path.count();
        for (uint32_t i = run.first; i <= run.last; ++i) {
            const double in = starts ? eased(double(i - run.first + 1) / turning_ramp) : 1;
            const double out = ends ? eased(double(run.last - i + 1) / turning_ramp) : 1;
            path.turning[i] = std::min({eased(path.turning[i]), in, out});
        }
    });
}

// Cycles a second.
double pace_at(const Locomotion &locomotion, double scale_m, const FinePath &path, uint32_t i, double phase)
{
    const double gait = std::max(min_gait, path.gait[i]), turning = path.turning[i];
    const double advance = double(cell_at(locomotion, gait, 0, phase).advance) * scale_m;
    const double rate = advance > 0 ? travel(locomotion, path, i, turn_step_m) / advance : 0;
    const double walks = std::min(rate, max_pace / cycle_s_at(locomotion, gait));
    if (!(turning > 0)) return walks;
    const double own = 1 / double(locomotion.turn_cycle_s);
    const double turns = std::clamp(path.turn[i] / turn_a_cycle_rad, min_turning_pace * own, max_pace * own);
    return walks + (turns - walks) * turning;
}

// The foot that begins to move: that on the side to which a standing person turns, or any.
int first_foot(const FinePath &path, uint32_t i, bool any)
{
    constexpr uint32_t soon = 12;
    const uint32_t last = std::min(i + soon, path.count() - 1);
    const double turn = path.heading[last] - path.heading[i];
    const bool walks = path.speed[last] > on_the_spot_m_s;
    return !walks && std::fabs(turn) > 0.05 ? (turn > 0 ? 0 : 1) : any;
}

// Returns the number of stands up to the end of the track.
uint32_t set_phase(const Locomotion &locomotion, const BuildSettings &settings, double scale_m, FinePath &path)
{
    path.phase.assign(path.count(), 0.0);
    path.idle.assign(path.count(), 0);
    const uint32_t idles = std::max(1u, locomotion.clips.idle_count);
    const Track *previous = path.previous;
    uint64_t number = previous ? previous->stand_count : 0;  // of the stand before this sample
    uint64_t number_at_end = number;
    const auto sample = [&](base::Purpose purpose) { return base::unit(base::hash(settings.seed, number, purpose)); };
    double phase = previous ? previous->samples.back().phase / 65536.0 : double(sample(base::Purpose::phase));
    uint8_t idle = static_cast<uint8_t>(sample(base::Purpose::idle) * static_cast<float>(idles));
    std::fill(path.phase.begin(), path.phase.begin() + path.first, phase);
    for (uint32_t i = path.first; i < path.count(); ++i) {
        const bool moved = i > path.first;
        // The next walk begins with the foot that leaves the ground; no one sees the phase of a stand.
        if (moved && path.stands[i] && path.stands[i - 1])
            phase = lift_of(locomotion, first_foot(path, i, !(sample(base::Purpose::pick) < 0.5f)));
        if (moved && !path.stands[i]) phase += pace_at(locomotion, scale_m, path, i, phase) / path.hz;
        if (moved && path.stands[i] && !path.stands[i - 1]) {
            ++number;
            idle = static_cast<uint8_t>(sample(base::Purpose::idle) * static_cast<float>(idles));
        }
        path.phase[i] = phase;
        path.idle[i] = idle;
        if (i == path.last) number_at_end = number;
    }
    // A stand is shown with its own clip from the moment at which the walk begins to fade.
    for (uint32_t i = path.count(); i-- > path.first + 1;)
        if (!path.stands[i - 1] && path.gait[i - 1] < 1) path.idle[i - 1] = path.idle[i];
    return static_cast<uint32_t>(number_at_end);
}

}  // namespace

uint32_t make_gait(const Locomotion &locomotion, const BuildSettings &settings, FinePath &path)
{
    const double scale_m = settings.scale * settings.metres_per_unit;
    set_gait(locomotion, scale_m, path);
    set_turning(locomotion, path);
    if (path.previous) join_gait(double(locomotion.max_gait()), path);
    const uint32_t stands = set_phase(locomotion, settings, scale_m, path);
    if (path.previous) join_idle(path);
    return stands;
}

}  // namespace claque::track
