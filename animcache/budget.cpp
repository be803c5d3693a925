// Selects the due poses that an update with a budget renews. As far as the budget allows, no pose is kept for more than
// twice its period: individuals near that limit come first, the most overdue before the others; then the nearest. Ties
// go by row. Individuals without a pose to show are never deferred.
#include <algorithm>

#include "animcache/caches.h"

namespace claque::animcache
{

namespace
{

constexpr double max_periods = 2;  // or as many updates, if updates are farther apart
// From this age on distance no longer counts. The margin serves updates in which many individuals reach it together.
constexpr double urgent_periods = 1.75;

}  // namespace

// A pose of another clip, other nodes or a later time cannot be shown.
bool Caches::can_wait(const Request &request, double time_s) const
{
    if (shows_key_poses(request.key_pose.mode)) return false;  // whether key-poses are kept must not be visible
    const Entry &entry = entries_[request.slot];
    return entry.palette_key.version == request.pose.version &&
           entry.palette_key.skeletal_level == request.pose.skeletal_level && entry.shown_s <= time_s &&
           entry.renewed_s <= time_s;
}

void Caches::defer(const PoseBudget &pose_budget)
{
    pose_budget_ = pose_budget;
    if (animate_.size() + without_room_ <= pose_budget.budget) return;
    waiting_.clear();
    for (uint32_t i = 0; i < animate_.size(); ++i) {
        const Request &request = requests_[animate_[i]];
        if (!can_wait(request, pose_budget.time_s)) continue;
        const double period = std::max({double(request.period_s), pose_budget.elapsed_s, 1e-9});
        const double age = pose_budget.time_s - entries_[request.slot].renewed_s;
        waiting_.push_back({(age + pose_budget.elapsed_s) / period, request.distance, request.row, i});
    }
    const uint32_t cannot_wait = static_cast<uint32_t>(animate_.size() - waiting_.size()) + without_room_;
    const uint32_t left = pose_budget.budget > cannot_wait ? pose_budget.budget - cannot_wait : 0;
    std::sort(waiting_.begin(), waiting_.end(), [](const Waiting &a, const Waiting &b) {
        const bool a_urgent = a.periods > urgent_periods, b_urgent = b.periods > urgent_periods;
        if (a_urgent != b_urgent) return a_urgent;
        if (a_urgent && a.periods != b.periods) return a.periods > b.periods;
        if (a.distance != b.distance) return a.distance < b.distance;
        return a.row < b.row;
    });
    for (uint32_t k = left; k < waiting_.size(); ++k) {
        Request &request = requests_[animate_[waiting_[k].due]];
        const Entry &entry = entries_[request.slot];
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
