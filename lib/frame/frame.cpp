#include "lib/frame/frame.h"

#include <algorithm>

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

size_t Update::colour_bytes() const
{
    size_t bytes = 0;
    for (uint32_t row = 0; row < crowd.row_count(); ++row)
        if (crowd.zone_rgb(row)) bytes += 3 * size_t(crowd.template_of(row).zone_count());
    return bytes;
}

void Update::reserve()
{
    const uint32_t rows = crowd.row_capacity();  // grows in steps, so that this does
    const size_t colours = colour_bytes();
    for (View *view : views) {
        view->list.items.reserve(rows);
        view->server.reserve(crowd.templates());
        if (std::max(view->colours.capacity(), view->grown.capacity()) < colours)
            view->grown.reserve(colours + colours / 2);
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
