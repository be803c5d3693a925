#include "lib/frame/frame.h"

#include <algorithm>

#include "lib/frame/steps.h"

namespace claque::frame
{

Frame::Frame(std::pmr::memory_resource *memory, const animcache::Settings &settings)
    : settings_(settings),
      caches_(memory, settings),
      rows_(memory),
      groups_(memory),
      blocks_(memory),
      candidates_(memory),
      block_seen_(memory),
      view_distances_(memory),
      visible_(memory),
      listed_(memory)
{
    stats_.cache_budget_bytes = settings.budget_bytes;
    reset_bands();
}

Seen Frame::seen(const crowd::Crowd &crowd, uint32_t row) const
{
    if (row >= rows_.size() || rows_[row].generation != crowd.actor(row).generation) return Seen();
    Seen seen = rows_[row].seen;
    seen.visible = seen.visible && rows_[row].update == update_;
    return seen;
}

bool Frame::group_seen(const crowd::Crowd &crowd, uint32_t group) const
{
    return group < groups_.size() && update_ > 0 && groups_[group].update == update_ &&
           groups_[group].generation == crowd.group(group).generation;
}

void Update::reserve()
{
    const uint32_t rows = crowd.row_capacity();  // grows in steps, so that this does
    const size_t colours = crowd.colour_bytes();
    for (View *view : views) {
        view->list.items.reserve(rows);
        view->server.reserve(crowd.templates());
        if (std::max(view->colours.capacity(), view->grown.capacity()) < colours)
            view->grown.reserve(colours + colours / 2);
    }
    frame.view_distances_.reserve(size_t(views.count) * rows);
    frame.blocks_.follow(crowd);
    frame.block_seen_.assign(size_t(views.count) * frame.blocks_.blocks().count, 0);
    frame.candidates_.reserve(rows);
    frame.visible_.reserve(rows);
    frame.listed_.reserve(rows);
    frame.caches_.reserve(rows, crowd.templates());
    if (frame.rows_.size() < rows) frame.rows_.resize(rows);
    if (frame.groups_.size() < crowd.group_count()) frame.groups_.resize(crowd.group_count());
}

void Update::find_due()
{
    frame.caches_.admit();
    frame.caches_.find_due();
}

void Update::animate() { frame.caches_.animate(jobs); }
void Update::skin() { frame.caches_.skin(jobs); }

}  // namespace claque::frame
