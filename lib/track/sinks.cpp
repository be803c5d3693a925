// How far the hips sink so that legs reach the treads that feet stand on. A body that goes along a ramp has one foot
// below and behind it; its hips stay as low as the lowest step wants them, without bobbing.
#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>

#include "lib/math/trig.h"
#include "lib/track/piece.h"

namespace claque::track
{

namespace
{

constexpr double bent_share = 0.985;  // of a leg's length: hips sink before a knee is straight
constexpr double calm_s = 0.3;        // before and after a step in which hips stay as low, and in which they move
constexpr double join_s = 0.4;        // in which what the piece before showed fades

// What the plant of a foot wants at a sample, metres.
double need_of(const Locomotion &locomotion, const FinePath &path, const Plant &plant, double scale_m, int f,
               uint32_t i)
{
    const double below = path.y[i] - double(plant.y);
    if (!(below > 0)) return 0;
    const GaitCell cell = cell_at(locomotion, path.gait[i], path.turning[i], path.phase[i]);
    const auto turned = [scale_m](float x, float z, double heading) {
        const double c = math::cos(heading), s = math::sin(heading);
        return glm::dvec2(double(x) * c + double(z) * s, -double(x) * s + double(z) * c) * scale_m;
    };
    const double own = path.heading[i], turn = nearest_turn(double(plant.heading_rad) - own, 0);
    const glm::dvec2 body(path.x[i], path.z[i]);
    const glm::dvec2 hip = body + turned(cell.hip_x[f], cell.hip_z[f], own);
    const glm::dvec2 node = glm::dvec2(plant.x, plant.z) +
                            turned(cell.node_x[f], cell.node_z[f],
                                   own + std::clamp(turn, -max_foot_turn_rad, max_foot_turn_rad) - double(cell.yaw[f]));
    return sink_wanted(double(locomotion.leg_length) * scale_m, double(cell.reach[f]) * scale_m,
                       glm::length(hip - node), below);
}

// The largest within `half` samples of each, then their mean.
void calm(Array<double> &need, uint32_t half)
{
    const auto count = static_cast<uint32_t>(need.size());
    Array<double> most(need.get_allocator().resource());
    most.resize(count);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t first = i > half ? i - half : 0, last = std::min(count - 1, i + half);
        most[i] = *std::max_element(need.begin() + first, need.begin() + last + 1);
    }
    need = most;
    smooth(need, 0, count - 1, half / 2, Beyond::still);
    smooth(need, 0, count - 1, half / 2, Beyond::still);
}

}  // namespace

double sink_wanted(double leg_m, double reach_m, double flat_m, double below_m)
{
    const auto high = [](double leg, double flat) { return leg > flat ? std::sqrt(leg * leg - flat * flat) : 0; };
    return std::clamp(high(leg_m, reach_m) + below_m - high(bent_share * leg_m, flat_m), 0.0, below_m);
}

void make_sinks(const Locomotion &locomotion, const FinePath &path, Track &out)
{
    const double before = path.previous ? sink_at(*path.previous, end_of(*path.previous)) : 0;
    out.climbs = out.climbs || before > 0;
    if (!out.climbs) return;
    const uint32_t count = path.count();
    Array<double> need(out.samples.get_allocator().resource());
    need.resize(count, 0.0);
    for (int f = 0; f < 2; ++f)
        for (const Plant &plant : out.plants[f]) {
            if (!std::isfinite(plant.y)) continue;
            const auto sample = [&](float time_s) {
                return std::clamp<double>(path.first + double(time_s) * path.hz + 0.5, 0, count);
            };
            const auto first = static_cast<uint32_t>(sample(plant.begin_s));
            for (uint32_t i = first; i < static_cast<uint32_t>(sample(plant.end_s)); ++i)
                need[i] = std::max(need[i], need_of(locomotion, path, plant, out.scale, f, i));
        }
    calm(need, static_cast<uint32_t>(calm_s * path.hz));
    const double most = max_sink * double(locomotion.leg_length) * out.scale;
    const double offset = path.previous ? before - need[path.first] : 0;
    const auto every = static_cast<uint32_t>(path.hz / out.rate_hz + 0.5);
    bool any = false;
    for (uint32_t k = 0; k < out.samples.size(); ++k) {
        const uint32_t i = std::min(path.first + k * every, count - 1);
        const double left = offset * (1 - eased((i - path.first) / path.hz / join_s));
        const double sink = std::clamp(need[i] + left, 0.0, most);
        out.sinks.push_back(static_cast<uint16_t>(std::min(65535.0, sink / sink_step_m + 0.5)));
        any = any || out.sinks.back() > 0;
    }
    if (!any) out.sinks.clear();
}

double sink_at(const Track &track, double time_s) noexcept
{
    if (track.sinks.empty()) return 0;
    const double last = double(track.sinks.size()) - 1;
    const double at = std::fmin(std::fmax((time_s - track.start_s) * track.rate_hz, 0), last);
    const auto first = static_cast<size_t>(at);
    const size_t next = first + 1 < track.sinks.size() ? first + 1 : first;
    const double from = track.sinks[first], to = track.sinks[next];
    return (from + (to - from) * (at - double(first))) * sink_step_m;
}

}  // namespace claque::track
