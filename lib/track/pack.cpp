// The fine path as samples of 16 bytes, on the coarsest grid from which it is found again.
#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/base/hash.h"
#include "lib/math/trig.h"
#include "lib/track/build.h"

namespace claque::track
{

namespace
{

constexpr double max_place_m = 0.0005, max_angle_rad = 0.01, max_phase = 0.02, max_gait = 0.05;

uint16_t turns(double of_one) { return static_cast<uint16_t>(static_cast<int64_t>(std::floor(of_one * 65536 + 0.5))); }

void fill(const FinePath &path, uint32_t every, Track &out)
{
    out.rate_hz = path.hz / every;
    out.samples.clear();
    out.samples.reserve((path.last - path.first) / every + 1);
    for (uint32_t i = path.first; i <= path.last; i += every) {
        Sample sample;
        sample.x = static_cast<int32_t>(std::floor(path.x[i] / place_step_m + 0.5));
        sample.z = static_cast<int32_t>(std::floor(path.z[i] / place_step_m + 0.5));
        if (out.height_step_m > 0)
            sample.height = static_cast<uint16_t>(
                std::min(65535.0, std::floor((path.y[i] - out.min_height_m) / out.height_step_m + 0.5)));
        sample.heading = turns(path.heading[i] / (2 * math::pi));
        sample.phase = turns(path.phase[i]);
        sample.gait = static_cast<uint8_t>(std::floor(path.gait[i] * gait_unit + 0.5));
        const uint32_t turn = static_cast<uint32_t>(path.turning[i] * turn_unit + 0.5);
        sample.flags =
            static_cast<uint8_t>((path.stands[i] ? stands_flag : 0) | path.idle[i] << idle_shift | turn << turn_shift);
        out.samples.push_back(sample);
    }
}

double away(double a, double b)
{
    const double d = a - b;
    return std::fabs(d - std::floor(d + 0.5));
}

// Whether the samples give the fine path back, but for the rounding of a sample itself.
bool is_near(const FinePath &path, const Track &track)
{
    for (uint32_t i = path.first; i <= path.last; ++i) {
        const State state = state_at(track, track.start_s + (i - path.first) / path.hz);
        const glm::dvec3 p = state.position * track.metres_per_unit - track.origin_m;
        if (std::fabs(p.x - path.x[i]) > max_place_m || std::fabs(p.z - path.z[i]) > max_place_m) return false;
        if (std::fabs(p.y - path.y[i]) > max_place_m + track.height_step_m) return false;
        const double turn = away(state.heading_rad / (2 * math::pi), path.heading[i] / (2 * math::pi));
        if (2 * math::pi * turn > max_angle_rad) return false;
        if (path.gait[i] > 0 && away(state.phase, path.phase[i]) > max_phase) return false;
        if (std::fabs(double(state.gait) - path.gait[i]) > max_gait) return false;
        if (std::fabs(double(state.turn) - path.turning[i]) > max_gait) return false;
    }
    return true;
}

}  // namespace

void pack(const FinePath &path, Track &out)
{
    const auto heights = std::minmax_element(path.y.begin() + path.first, path.y.begin() + path.last + 1);
    out.min_height_m = *heights.first;
    const double range = *heights.second - *heights.first;
    out.height_step_m = range > 0 ? range / 65535 : 0;
    for (const uint32_t every : {5u, 4u, 2u, 1u}) {
        if ((path.last - path.first) % every != 0) continue;
        fill(path, every, out);
        if (every == 1 || is_near(path, out)) return;
    }
}

namespace
{

// For each whole second the first of `all` that ends after it began.
template <class Element, class End>
void index_by_second(const Array<Element> &all, double length_s, const End &end, Array<uint32_t> &out)
{
    out.resize(static_cast<size_t>(length_s) + 1);
    uint32_t i = 0;
    for (size_t s = 0; s < out.size(); ++s) {
        while (i < all.size() && end(all[i]) < double(s)) ++i;
        out[s] = i;
    }
}

}  // namespace

void index_plants(Track &track)
{
    for (int f = 0; f < 2; ++f)
        index_by_second(
            track.plants[f], track.length_s, [](const Plant &p) { return double(p.end_s); }, track.first_plants[f]);
    for (const Array<Plant> &plants : track.plants)
        for (const Plant &plant : plants) track.climbs = track.climbs || std::isfinite(plant.y);
    for (const Swing &swing : track.swings) track.climbs = track.climbs || swing.y != 0;
    if (track.shoulders.empty()) return;
    const auto end = [](const ShoulderTurn &turn) { return double(turn.at_s) + double(turn.half_s); };
    index_by_second(track.shoulders, track.length_s, end, track.first_shoulders);
}

uint64_t hash_of(const Track &track)
{
    uint64_t h = base::fnv_start;
    const auto add = [&h](const auto &value) { h = base::fnv(h, &value, sizeof value); };
    add(track.origin_m.x), add(track.origin_m.y), add(track.origin_m.z);
    add(track.start_s), add(track.length_s), add(track.rate_hz), add(track.min_height_m), add(track.height_step_m);
    add(track.metres_per_unit), add(track.scale);
    h = base::fnv(h, track.samples.data(), track.samples.size() * sizeof(Sample));
    // Heights only where there are some: a track on level ground is what it was before there were heights.
    for (const Array<Plant> &plants : track.plants)
        for (const Plant &plant : plants) h = base::fnv(h, &plant, level_plant_bytes);
    for (const Array<Plant> &plants : track.plants)
        for (const Plant &plant : plants)
            if (track.climbs) add(plant.y), add(plant.slope);
    h = base::fnv(h, track.sinks.data(), track.sinks.size() * sizeof(uint16_t));
    h = base::fnv(h, track.shoulders.data(), track.shoulders.size() * sizeof(ShoulderTurn));
    h = base::fnv(h, track.ahead.data(), track.ahead.size() * sizeof(uint16_t));
    if (track.previous_hash == 0) return h;
    add(track.previous_hash);
    for (const Swing &swing : track.swings) h = base::fnv(h, &swing, level_swing_bytes);
    add(track.stand_count), add(track.upper_swing);
    for (const Swing &swing : track.swings)
        if (track.climbs) add(swing.y);
    return h;
}

}  // namespace claque::track
