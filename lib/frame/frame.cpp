#include "lib/frame/frame.h"

#include <algorithm>

#include "lib/frame/steps.h"

namespace claque::frame
{

namespace
{

// Traditional processing computes everything in every frame.
Settings without_caches_if_traditional(Settings settings)
{
    if (settings.cull == Cull::traditional) settings.caches.mode = animcache::Mode::none;
    return settings;
}

}  // namespace

Frame::Frame(std::pmr::memory_resource *memory, const Settings &settings)
    : settings_(without_caches_if_traditional(settings)),
      caches_(memory, settings_.caches),
      rows_(memory),
      groups_(memory),
      blocks_(memory),
      eyes_(memory),
      block_visible_(memory),
      tested_(memory),
      passed_(memory),
      candidates_(memory),
      view_visibilities_(memory),
      requested_(memory),
      visible_(memory),
      layers_(memory),
      masks_(memory),
      dofs_(memory),
      behaving_(memory),
      listed_(memory),
      ordered_(memory)
{
    stats_.cache_budget_bytes = settings.caches.budget_bytes;
    reset_bands();
}

void Frame::forget()
{
    std::fill(rows_.begin(), rows_.end(), Row());
    std::fill(groups_.begin(), groups_.end(), GroupRow());
    has_last_time_ = false;
}

ActorVisibility Frame::visibility(const crowd::Crowd &crowd, uint32_t row) const
{
    if (row >= rows_.size() || rows_[row].generation != crowd.actor(row).generation) return ActorVisibility();
    ActorVisibility visibility = rows_[row].visibility;
    visibility.visible = visibility.visible && rows_[row].update == update_;
    return visibility;
}

bool Frame::root_of(const crowd::Crowd &crowd, uint32_t row, crowd::Transform &out) const
{
    if (!visibility(crowd, row).visible) return false;
    out = candidates_[rows_[row].candidate].root;
    return true;
}

bool Frame::group_visible(const crowd::Crowd &crowd, uint32_t group) const
{
    return group < groups_.size() && update_ > 0 && groups_[group].update == update_ &&
           groups_[group].generation == crowd.group(group).generation;
}

void Update::reserve()
{
    const uint32_t rows = crowd.row_capacity();  // grows in steps, so that this does
    frame.eyes_.clear();
    for (const View *view : views) frame.eyes_.emplace_back(*view);
    const size_t colours = crowd.colour_bytes();
    for (View *view : views) {
        view->list.items.reserve(rows);
        view->hooked.reserve(crowd.hooked_count());
        view->server.reserve(crowd.templates(), frame.settings_.caches);
        if (std::max(view->colours.capacity(), view->grown.capacity()) < colours)
            view->grown.reserve(colours + colours / 2);
    }
    frame.passed_.reserve(size_t(views.count) * rows);
    frame.view_visibilities_.reserve(size_t(views.count) * rows);
    frame.tested_.reserve(rows);
    frame.requested_.reserve(rows);
    frame.behaving_.reserve(rows);
    frame.max_dofs_ = 0;
    for (const model::Template *tmpl : crowd.templates())
        frame.max_dofs_ = std::max(frame.max_dofs_, static_cast<uint32_t>(tmpl->rig.dofs.size()));
    if (crowd.behaviours().mechanism_count() > 0) {
        const size_t dofs = (size_t(rows) + 1) * frame.max_dofs_;
        if (frame.dofs_.size() < dofs) frame.dofs_.resize(dofs);
    }
    frame.blocks_.follow(crowd);
    frame.block_visible_.assign(size_t(views.count) * frame.blocks_.blocks().count, 0);
    frame.candidates_.reserve(rows);
    frame.visible_.reserve(rows);
    frame.listed_.reserve(rows);
    frame.ordered_.reserve(rows);
    frame.caches_.reserve(rows, crowd.templates());
    if (frame.rows_.size() < rows) frame.rows_.resize(rows);
    if (frame.groups_.size() < crowd.group_count()) frame.groups_.resize(crowd.group_count());
    reserve_layers();
}

void Update::find_due()
{
    frame.caches_.allocate_poses();
    frame.caches_.find_due_poses();
    keep_to_budget();
}

void Update::animate() { frame.caches_.animate(jobs); }

void Update::skin()
{
    frame.caches_.allocate_vertices();
    frame.caches_.find_due_vertices();
    frame.caches_.skin(jobs);
}

}  // namespace claque::frame
