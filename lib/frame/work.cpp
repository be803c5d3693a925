#include "lib/frame/work.h"

#include <algorithm>

#include "lib/base/held_bytes.h"
#include "lib/base/slack.h"

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

// Whether the update may call callbacks of the host that make it fail if they throw.
bool may_throw(const crowd::Crowd &crowd) { return crowd.ground() || crowd.behaviours().any_host(); }

template <class Array>
void grow(Array &array, size_t count)
{
    if (array.size() < count) array.resize(count);
}

// The same for counts that change from update to update.
template <class Array>
void grow_with_slack(Array &array, size_t count)
{
    if (array.size() < count) array.resize(count + count / 4);
}

// The callbacks move, so the list that is still shown is pointed at them again: they are in its order.
void reserve_hooks(View &view, size_t count)
{
    if (view.hooked.capacity() >= count) return;
    view.hooked.reserve(count);
    size_t k = 0;
    for (draw::Item &item : view.list.items) {
        if (!item.hooks) continue;
        Hooked &hooked = view.hooked[k++];
        hooked.hooks.user = &hooked;
        item.hooks = &hooked.hooks;
    }
}

void reserve_view(View &view, const crowd::Crowd &crowd, uint32_t count)
{
    base::reserve_with_slack(view.list.items, count);
    reserve_hooks(view, crowd.hooked_count());
    size_t most = 0;  // bytes of one individual's colours
    for (const model::Template *tmpl : crowd.templates()) most = std::max(most, 3 * size_t(tmpl->zone_count()));
    const size_t colours = std::min(size_t(crowd.colour_bytes()), count * most);
    if (std::max(view.colours.capacity(), view.grown.capacity()) < colours) view.grown.reserve(colours + colours / 2);
}

}  // namespace

Work::Work(std::pmr::memory_resource *memory, const Settings &wanted)
    : settings(without_caches_if_traditional(wanted)),
      caches(memory, settings.caches),
      seen(memory),
      rows(memory),
      groups(memory),
      blocks(memory),
      view_changes(memory),
      eyes(memory),
      block_seen(memory),
      tested(memory),
      motions(memory),
      passed(memory),
      candidates(memory),
      visibilities(memory),
      visible(memory),
      layers(memory),
      dofs(memory),
      behaving(memory),
      listed(memory),
      ordered(memory),
      last(memory)
{
    stats.cache_budget_bytes = settings.caches.budget_bytes;
}

void Work::reserve(const crowd::Crowd &crowd, base::Span<View *const> views)
{
    const uint32_t count = crowd.row_capacity();  // grows in steps, so these arrays do too
    eyes.clear();
    for (const View *view : views) eyes.emplace_back(*view);
    grow(passed, count);
    grow(tested, count);
    grow_with_slack(motions, crowd.follows().slot_count());
    blocks.follow(crowd);
    grow(block_seen, size_t(views.count) * blocks.blocks().count);
    grow(groups, crowd.group_count());
}

void Work::reserve_candidates(const crowd::Crowd &crowd, base::Span<View *const> views, uint32_t count, uint32_t unseen)
{
    for (View *view : views) reserve_view(*view, crowd, count);
    grow_with_slack(visibilities, size_t(views.count) * count);
    grow_with_slack(may_throw(crowd) ? last.candidates : candidates, count);
    grow_with_slack(visible, count);
    grow_with_slack(behaving, count);
    dofs_each = 0;
    for (const model::Template *tmpl : crowd.templates())
        dofs_each = std::max(dofs_each, static_cast<uint32_t>(tmpl->rig.dofs.size()));
    if (crowd.behaviours().mechanism_count() > 0) grow(last.dofs, (size_t(count) + 1) * dofs_each);
    const size_t on_track = 3;
    const size_t of_crowd =
        size_t(crowd.layers().slot_count()) * pose::max_layers + on_track * size_t(crowd.follows().slot_count());
    const size_t max_layers = std::min(of_crowd, count * (pose::max_layers + on_track)) +
                              (crowd.behaviours().any_blend() ? 2 * size_t(count) : 0);
    if (last.layers.capacity() < max_layers) {
        last.layers.clear();
        last.layers.reserve(max_layers + max_layers / 2);
    }
    base::reserve_with_slack(listed, count);
    base::reserve_with_slack(ordered, count);
    seen.reserve(crowd.row_capacity());
    const uint32_t slot_count = seen.count() + unseen;
    caches.reserve(slot_count, crowd.templates(), may_throw(crowd), count);
    grow_with_slack(rows, slot_count);
    view_changes.reserve(crowd.row_capacity());
    if (may_throw(crowd)) {
        last.rows.reserve(rows.capacity());
        last.groups.reserve(groups.capacity());
    }
}

void Work::begin(const crowd::Crowd &crowd)
{
    const bool can_undo = may_throw(crowd);
    last.layers.swap(layers);
    last.dofs.swap(dofs);
    if (can_undo) {
        last.candidates.swap(candidates);
        last.rows.assign(rows.begin(), rows.end());
        last.groups.assign(groups.begin(), groups.end());
        last.stats = stats;
        last.live_since = live_since;
    }
    ++update;
    caches.begin_over(can_undo);
}

void Work::undo()
{
    last.layers.swap(layers);
    last.dofs.swap(dofs);
    last.candidates.swap(candidates);
    last.rows.swap(rows);
    last.groups.swap(groups);
    stats = last.stats;
    live_since = last.live_since;
    --update;
    caches.undo();
}

uint64_t Work::bytes() const
{
    return base::held_bytes(rows, groups, eyes, block_seen, tested, motions, passed, candidates, visibilities, visible,
                            layers, dofs, behaving, listed, ordered, last.rows, last.groups, last.candidates,
                            last.layers, last.dofs) +
           blocks.bytes() + view_changes.bytes() + seen.bytes() + caches.book_bytes() + caches.counters().arena_bytes;
}

}  // namespace claque::frame
