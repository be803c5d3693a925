// How many poses an update may renew (live clock only). A deferred actor shows its last pose, with the tick and
// the mechanism levels of that pose.
#include <algorithm>

#include "lib/frame/steps.h"

namespace claque::frame
{

// Converts a budget in milliseconds to a number of poses, by their measured cost.
uint32_t KeepToBudget::budget() const
{
    const Settings &settings = given.settings;
    uint32_t poses = settings.update_budget > 0 ? settings.update_budget : model::none;
    if (settings.update_budget_ms > 0 && pose_cost_s > 0) {
        const double fit = double(settings.update_budget_ms) * 1e-3 / pose_cost_s;
        if (fit < double(poses)) poses = std::max(1u, static_cast<uint32_t>(fit));
    }
    return poses;
}

base::Status KeepToBudget::check() const
{
    if (caches.requests().count != candidates.count ||
        !has_slots({candidates.data, candidates.count}, {rows.data, rows.count}))
        return base::Status::bad(CLQ_ARGUMENT, "no request of every candidate, or no room for its results");
    if (!(elapsed_s >= 0)) return base::Status::bad(CLQ_ARGUMENT, "%g seconds since the last update", elapsed_s);
    return base::Status::good();
}

void KeepToBudget::run() const
{
    if (!given.settings.caches.can_defer) return;
    animcache::Caches::PoseBudget context;
    context.time_s = given.time_s;
    context.elapsed_s = elapsed_s;
    context.budget = budget();
    caches.defer(context);
    if (caches.counters().deferred == 0) return;
    const std::pmr::vector<animcache::Request> &requests = caches.pending();
    for (uint32_t i = 0; i < requests.size(); ++i) {
        const animcache::Request &request = requests[i];
        if (!request.tmpl) continue;
        Row &row = rows[request.slot];
        if (row.visibility.shown_s == request.shown_s) continue;
        row.visibility.shown_s = request.shown_s;
        if (given.crowd.behaviours().has_mechanisms(request.row)) candidates[i].levels = request.pose.behaviour_levels;
    }
}

}  // namespace claque::frame
