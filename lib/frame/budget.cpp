// How many poses an update may renew (SPEC 2: live mode only), and what follows for who must wait: it shows its last
// pose, with the tick and the levels of behaviour that this was made for.
#include <algorithm>

#include "lib/frame/steps.h"

namespace claque::frame
{

// A budget in milliseconds is one of poses, by what they cost last.
uint32_t Update::budget() const
{
    const Settings &settings = frame.settings_;
    uint32_t poses = settings.update_budget > 0 ? settings.update_budget : model::none;
    if (settings.update_budget_ms > 0 && frame.pose_cost_s_ > 0) {
        const double fit = double(settings.update_budget_ms) * 1e-3 / frame.pose_cost_s_;
        if (fit < double(poses)) poses = std::max(1u, static_cast<uint32_t>(fit));
    }
    return poses;
}

double Update::now() const
{
    const Settings &settings = frame.settings_;
    return settings.update_budget_ms > 0 ? settings.now.now_s(settings.now.user) : 0;
}

// Half of what is known comes from the last update: a machine's load changes, and one update may be a freak.
void Update::learn_cost(double spent_s)
{
    const uint32_t posed = frame.caches_.counters().animated;
    if (!(frame.settings_.update_budget_ms > 0) || posed == 0 || !(spent_s > 0)) return;
    const double cost = spent_s / posed;
    frame.pose_cost_s_ = frame.pose_cost_s_ > 0 ? (frame.pose_cost_s_ + cost) / 2 : cost;
}

void Update::keep_to_budget()
{
    if (!frame.settings_.caches.can_defer) return;
    animcache::Caches::PoseBudget context;
    context.time_s = time_s;
    context.elapsed_s = frame.has_last_time_ ? std::max(0.0, time_s - frame.last_time_s_) : 0;
    context.budget = budget();
    frame.caches_.defer(context);
    if (frame.caches_.counters().deferred == 0) return;
    const std::pmr::vector<animcache::Request> &requests = frame.caches_.pending();
    for (uint32_t i = 0; i < requests.size(); ++i) {
        const animcache::Request &request = requests[i];
        Row &row = frame.rows_[request.row];
        if (row.visibility.shown_s == request.shown_s) continue;
        row.visibility.shown_s = request.shown_s;
        if (crowd.behaviours().has_mechanisms(request.row))
            frame.candidates_[frame.requested_[i]].levels = request.pose.behaviour_levels;
    }
}

}  // namespace claque::frame
