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

// Metres a second that the feet travel.
double travel(const FinePath &path, uint32_t i) { return path.speed[i] + turn_step_m * path.turn[i]; }

double gait_of(const Locomotion &locomotion, double speed_m_s, double scale_m)
{
    const double walk = locomotion.walking_speed() * scale_m;
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
            path.gait[i] = gait_of(locomotion, path.speed[i] + turn_stride_m * path.turn[i], scale_m);
        smooth(path.gait, run.first, run.last, 12, Beyond::still);
        const bool starts = run.first > 0, ends = run.last + 1 < path.count();
        for (uint32_t i = run.first; i <= run.last; ++i) {
            const double in = starts ? eased(double(i - run.first + 1) / ramp_samples) : 1;
            const double out = ends ? eased(double(run.last - i + 1) / ramp_samples) : 1;
            path.gait[i] *= std::min(in, out);
        }
    });
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
            phase = lift_of(locomotion, sample(base::Purpose::pick) < 0.5f ? 0 : 1);
        if (moved && !path.stands[i]) {
            const double gait = std::max(min_gait, path.gait[i]);
            const double advance = double(cell_at(locomotion, gait, phase).advance) * scale_m;
            const double rate = advance > 0 ? travel(path, i) / advance : 0;
            phase += std::min(rate, max_pace / cycle_s_at(locomotion, gait)) / path.hz;
        }
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
    if (path.previous) join_gait(double(locomotion.max_gait()), path);
    const uint32_t stands = set_phase(locomotion, settings, scale_m, path);
    if (path.previous) join_idle(path);
    return stands;
}

}  // namespace claque::track
