// The people of files that others made, as samples.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fixture.h"

namespace claque::testing
{

using Samples = std::vector<clq_trajectory_sample>;

// The samples of each id, without vehicles: the table knows nothing of people who become several.
inline std::vector<Samples> by_id(const asset::Trajectories &read)
{
    std::vector<Samples> out;
    std::string before;
    for (const asset::Person &person : read.people) {
        const auto begin = read.samples.begin() + static_cast<std::ptrdiff_t>(person.first);
        if (begin->flags & CLQ_TRAJECTORY_VEHICLE) continue;
        const std::string id = std::string(person.id).substr(0, std::string(person.id).find('#'));
        if (id != before) out.emplace_back();
        before = id;
        out.back().insert(out.back().end(), begin, begin + static_cast<std::ptrdiff_t>(person.count));
    }
    return out;
}

// Where a person is at multiples of a time.
inline Samples sampled(const Samples &all, double every_s)
{
    Samples out;
    size_t i = 0;
    for (double k = std::ceil(all[0].time_s / every_s - 1e-9); k * every_s <= all.back().time_s + 1e-9; ++k) {
        const double t = std::clamp(k * every_s, all[0].time_s, all.back().time_s);
        while (i + 2 < all.size() && all[i + 1].time_s < t) ++i;
        clq_trajectory_sample at = all[i];
        if (all.size() > 1) {
            const double part = (t - all[i].time_s) / (all[i + 1].time_s - all[i].time_s);
            at.x += part * (all[i + 1].x - at.x), at.y += part * (all[i + 1].y - at.y);
        }
        at.time_s = t;
        out.push_back(at);
    }
    return out;
}

}  // namespace claque::testing
