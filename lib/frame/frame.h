// One update of a crowd: culls actors, selects their rates and levels, poses and skins them, and lists them (S0 4.2, S1
// 4).
#pragma once

#include "lib/base/status.h"
#include "lib/crowd/crowd.h"
#include "lib/frame/work.h"

namespace claque::frame
{

// State and caches that updates of one crowd keep. Give each crowd one, with the same memory resource.
class Frame
{
public:
    Frame(std::pmr::memory_resource *memory, const Settings &settings);

    const Stats &stats() const { return work_.stats; }
    void reset_bands();
    void set_step_clock(const HostClock &clock) { work_.step_clock = clock; }
    const StepTimes &step_times() const { return work_.step_times; }
    void forget();  // clears visibility after the crowd's state was replaced; caches detect changed states themselves
    // A row whose individual was added after the last update is not visible.
    ActorVisibility visibility(const crowd::Crowd &crowd, uint32_t row) const;
    // Where the Skeleton Root of a row was in the world in the last update. False: that update did not see the row.
    bool root_of(const crowd::Crowd &crowd, uint32_t row, crowd::Transform &out) const;
    const Settings &settings() const { return work_.settings; }
    double last_time_s() const { return work_.last_time_s; }  // of the last update; 0 before the first
    // The mechanism levels of a row that the last update saw, at the distance that it had there. They are chosen anew,
    // because the host may have attached other mechanisms since. `level`: of its template.
    behave::MechanismLevels mechanism_levels(const crowd::Crowd &crowd, uint32_t row, const model::Level &level) const
    {
        const float distance_m = work_.candidates[work_.rows[work_.seen.slot_of(row)].candidate].effective_distance_m;
        return behave::mechanism_levels(crowd, row, distance_m, level);
    }
    // What an item of a list of the last update shows. Rows may have other individuals by now.
    const animcache::Request &request_of(const draw::Item &item) const { return work_.caches.requests()[item.request]; }
    const ViewChanges &view_changes() const { return work_.view_changes; }
    // Whether any view of the last update met the group's sphere; false for a disabled or empty group.
    bool group_visible(const crowd::Crowd &crowd, uint32_t group) const;

private:
    friend base::Status update(const crowd::Crowd &crowd, Frame &frame, base::Span<View *const> views, double time_s,
                               const base::Jobs &jobs) noexcept;

    Work work_;
};

// One update. time_s: the host's clock; it may jump, also back. What is shown is a function of time and distances.
//   views   each with its camera; their draw lists are written. The lists of other views may point at freed memory
//           afterwards, so the caller clears them
// Fails with CLQ_ARGUMENT (a time or camera that is not finite), CLQ_OUT_OF_MEMORY or CLQ_CALLBACK (the ground or a
// host mechanism threw); lists and results are unchanged then. Never throws. Allocates only when something has grown
// since the last update.
base::Status update(const crowd::Crowd &crowd, Frame &frame, base::Span<View *const> views, double time_s,
                    const base::Jobs &jobs) noexcept;

}  // namespace claque::frame
