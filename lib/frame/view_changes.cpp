#include "lib/frame/view_changes.h"

#include <algorithm>
#include <utility>

namespace claque::frame
{

void ViewChanges::reserve(uint32_t rows)
{
    for (base::Bitmap *bits : {&now_, &before_, &fresh_}) bits->reserve(rows);
    if (generations_.size() < rows) generations_.resize(rows);
}

void ViewChanges::note(const crowd::Crowd &crowd, base::Span<const Candidate> candidates,
                       base::Span<const uint32_t> visible) noexcept
{
    std::swap(now_, before_);
    now_.clear(), fresh_.clear();
    for (const uint32_t i : visible) now_.insert(candidates[i].row);
    if (structure_ == crowd.structure_version()) return;
    structure_ = crowd.structure_version();
    for (uint32_t row = 0; row < crowd.row_count(); ++row) {
        if (!crowd.alive(row) || generations_[row] == crowd.actor(row).generation) continue;
        generations_[row] = crowd.actor(row).generation;
        fresh_.insert(row);
    }
}

void ViewChanges::forget() noexcept
{
    for (base::Bitmap *bits : {&now_, &before_, &fresh_}) bits->clear();
    std::fill(generations_.begin(), generations_.end(), 0);
    structure_ = 0;
}

}  // namespace claque::frame
