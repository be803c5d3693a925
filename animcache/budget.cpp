// Which due poses are renewed where an update may not renew them all. Nobody keeps a pose longer than twice its period as
// long as the budget allows it: who would come near that goes first, who is farthest beyond before the others; then who is
// near. Ties go by row. Who has no pose to show is not asked to wait.
#include <algorithm>

#include "animcache/caches.h"

namespace claque::animcache
{

namespace
{

constexpr double max_periods = 2;  // or as many updates, where these are farther apart
// From here on distance counts no more. The rest is leeway for updates in which many come to this point at once.
constexpr double urgent_periods = 1.75;

}  // namespace

// A pose of another clip, of other nodes or of a time that is yet to come does not serve.
bool Caches::can_wait(const Request &request, double time_s) const
{
    if (shows_key_poses(request.key_pose.mode)) return false;  // what is kept of them must not be seen
    const Entry &entry = entries_[request.row];
    return entry.palette_key.version == request.pose.version &&
           entry.palette_key.skeletal_level == request.pose.skeletal_level && entry.shown_s <= time_s &&
           entry.renewed_s <= time_s;
}

void Caches::defer(const PoseBudget &pose_budget)
{
    pose_budget_ = pose_budget;
    if (animate_.size() <= pose_budget.budget) return;
    waiting_.clear();
    for (uint32_t i = 0; i < animate_.size(); ++i) {
        const Request &request = requests_[animate_[i]];
        if (!can_wait(request, pose_budget.time_s)) continue;
        const double period = std::max({double(request.period_s), pose_budget.elapsed_s, 1e-9});
        const double age = pose_budget.time_s - entries_[request.row].renewed_s;
        waiting_.push_back({(age + pose_budget.elapsed_s) / period, request.distance, request.row, i});
    }
    const uint32_t cannot_wait = static_cast<uint32_t>(animate_.size() - waiting_.size());
    const uint32_t left = pose_budget.budget > cannot_wait ? pose_budget.budget - cannot_wait : 0;
    counters_.over_budget = cannot_wait > pose_budget.budget ? cannot_wait - pose_budget.budget : 0;
    std::sort(waiting_.begin(), waiting_.end(), [](const Waiting &a, const Waiting &b) {
        const bool a_urgent = a.periods > urgent_periods, b_urgent = b.periods > urgent_periods;
        if (a_urgent != b_urgent) return a_urgent;
        if (a_urgent && a.periods != b.periods) return a.periods > b.periods;
        if (a.distance != b.distance) return a.distance < b.distance;
        return a.row < b.row;
    });
    for (uint32_t k = left; k < waiting_.size(); ++k) {
        Request &request = requests_[animate_[waiting_[k].due]];
        const Entry &entry = entries_[request.row];
        const double period = std::max(double(request.period_s), pose_budget.elapsed_s);
        counters_.overdue += pose_budget.time_s - entry.renewed_s > max_periods * period * (1 + 1e-6);
        ++counters_.deferred;
        request.pose = entry.palette_key;
        request.blend_radius = entry.palette_radius;
        request.shown_s = entry.shown_s;
        animate_[waiting_[k].due] = model::none;
    }
    animate_.erase(std::remove(animate_.begin(), animate_.end(), model::none), animate_.end());
}

}  // namespace claque::animcache
