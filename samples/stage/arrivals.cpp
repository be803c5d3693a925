#include "samples/stage/arrivals.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/random.h"

namespace staged
{

using namespace scenes;

namespace
{

// A point within the rectangle round an outline.
std::array<double, 3> point_in(const Outline &outline, double u, double v)
{
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < outline.size(); ++i) {
        low[i % 2] = std::min(low[i % 2], outline[i]);
        high[i % 2] = std::max(high[i % 2], outline[i]);
    }
    return {low[0] + u * (high[0] - low[0]), 0, low[1] + v * (high[1] - low[1])};
}

}  // namespace

bool is_within(const Outline &outline, double x, double z)
{
    bool left = false, right = false;
    const size_t count = outline.size() / 2;
    for (size_t i = 0; i < count; ++i) {
        const size_t next = (i + 1) % count;
        const double ax = outline[2 * i], az = outline[2 * i + 1];
        const double side = (outline[2 * next] - ax) * (z - az) - (outline[2 * next + 1] - az) * (x - ax);
        (side < 0 ? left : right) = true;
    }
    return !(left && right);
}

std::vector<Arrival> arrivals_of(const Staging &stage, uint64_t seed)
{
    std::vector<Arrival> all;
    uint32_t number = 0;
    for (const ScenarioAgents &agents : stage.agents) {
        double due_s = agents.from_s > 0 || agents.per_minute > 0 ? agents.from_s : begin_s;
        for (uint32_t k = 0; k < agents.count; ++k, ++number) {
            all.push_back({number, due_s});
            // Gaps between half the mean and one and a half.
            if (agents.per_minute > 0)
                due_s += 60 / agents.per_minute * random_between(seed, number, Purpose::gap, 0.5, 1.5);
        }
    }
    std::stable_sort(all.begin(), all.end(), [](const Arrival &a, const Arrival &b) { return a.due_s < b.due_s; });
    return all;
}

bool find_spot(const Staging &stage, const ScenarioAgents &agents, uint64_t seed, uint32_t attempt,
               const OnGround &on_ground, const IsFree &is_free, Spot &out)
{
    const double u = random_unit(seed, attempt, Purpose::place_x), v = random_unit(seed, attempt, Purpose::place_z);
    std::array<double, 3> at;
    if (agents.from.empty()) {
        at = point_in(agents.outline, u, v);
        if (!is_within(agents.outline, at[0], at[2])) return false;
    } else {
        const uint64_t which = random_bits(seed, attempt, Purpose::seat) % agents.from.size();
        at = stage.places[agents.from[which]].position;
        const double x = (2 * u - 1) * agents.within_m, z = (2 * v - 1) * agents.within_m;
        if (x * x + z * z > agents.within_m * agents.within_m) return false;
        at[0] += x, at[2] += z;
    }
    if (!on_ground(at) || !is_free(at, agents.apart_m)) return false;
    out.position = at;
    out.heading_rad = agents.heading_deg.value_or(random_between(seed, attempt, Purpose::heading, -180, 180)) * radians;
    return true;
}

}  // namespace staged
