#include "lib/frame/frame.h"

#include "lib/frame/steps.h"

namespace claque::frame
{

Frame::Frame(std::pmr::memory_resource *memory, const animcache::Settings &settings)
    : settings_(settings), caches_(memory, settings), rows_(memory), view_distances_(memory), listed_(memory)
{
    stats_.cache_budget_bytes = settings.budget_bytes;
    reset_bands();
}

Seen Frame::seen(const crowd::Crowd &crowd, uint32_t row) const
{
    if (row >= rows_.size() || rows_[row].generation != crowd.actor(row).generation) return Seen();
    return rows_[row].seen;
}

void Update::reserve()
{
    const uint32_t rows = crowd.row_capacity();  // grows in steps, so that this does
    for (View *view : views) {
        view->list.items.reserve(rows);
        view->server.reserve(crowd.templates());
    }
    frame.view_distances_.reserve(size_t(views.count) * rows);
    frame.view_distances_.resize(size_t(views.count) * crowd.row_count());
    frame.listed_.reserve(rows);
    frame.caches_.reserve(rows, crowd.templates());
    if (frame.rows_.size() < rows) frame.rows_.resize(rows);
}

void Update::find_due()
{
    frame.caches_.admit();
    frame.caches_.find_due();
}

void Update::animate() { frame.caches_.animate(jobs); }
void Update::skin() { frame.caches_.skin(jobs); }

}  // namespace claque::frame
