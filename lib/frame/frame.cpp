#include "lib/frame/frame.h"

#include <algorithm>

namespace claque::frame
{

Frame::Frame(std::pmr::memory_resource *memory, const Settings &settings) : work_(memory, settings) { reset_bands(); }

void Frame::forget()
{
    std::fill(work_.rows.begin(), work_.rows.end(), Row());
    std::fill(work_.groups.begin(), work_.groups.end(), GroupRow());
    work_.view_changes.forget();
    work_.has_last_time = false;
}

ActorVisibility Frame::visibility(const crowd::Crowd &crowd, uint32_t row) const
{
    const uint32_t slot = work_.seen.slot_of(row);
    if (slot == model::none || work_.rows[slot].generation != crowd.actor(row).generation) return ActorVisibility();
    ActorVisibility visibility = work_.rows[slot].visibility;
    visibility.visible = visibility.visible && work_.rows[slot].update == work_.update;
    return visibility;
}

bool Frame::root_of(const crowd::Crowd &crowd, uint32_t row, crowd::Transform &out) const
{
    if (!visibility(crowd, row).visible) return false;
    out = work_.candidates[work_.rows[work_.seen.slot_of(row)].candidate].root;
    return true;
}

bool Frame::group_visible(const crowd::Crowd &crowd, uint32_t group) const
{
    return group < work_.groups.size() && work_.update > 0 && work_.groups[group].update == work_.update &&
           work_.groups[group].generation == crowd.group(group).generation;
}

}  // namespace claque::frame
