#include "lib/frame/work.h"

#include <algorithm>

#include "lib/base/held_bytes.h"

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

void reserve_view(View &view, const crowd::Crowd &crowd)
{
    view.list.items.reserve(crowd.row_capacity());
    reserve_hooks(view, crowd.hooked_count());
    const size_t colours = crowd.colour_bytes();
    if (std::max(view.colours.capacity(), view.grown.capacity()) < colours) view.grown.reserve(colours + colours / 2);
}

}  // namespace

Work::Work(std::pmr::memory_resource *memory, const Settings &wanted)
    : settings(without_caches_if_traditional(wanted)),
      caches(memory, settings.caches),
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
    for (View *view : views) reserve_view(*view, crowd);
    grow(passed, size_t(views.count) * count);
    grow(visibilities, size_t(views.count) * count);
    grow(tested, count);
    if (crowd.follows().count() > 0) grow(motions, count);
    if (may_throw(crowd)) grow(last.candidates, count);
    else grow(candidates, count);
    grow(visible, count);
    grow(behaving, count);
    dofs_each = 0;
    for (const model::Template *tmpl : crowd.templates())
        dofs_each = std::max(dofs_each, static_cast<uint32_t>(tmpl->rig.dofs.size()));
    if (crowd.behaviours().mechanism_count() > 0) grow(last.dofs, (size_t(count) + 1) * dofs_each);
    const size_t max_layers = size_t(crowd.layers().slot_count()) * pose::max_layers +
                              3 * size_t(crowd.follows().slot_count()) +
                              (crowd.behaviours().any_blend() ? 2 * size_t(count) : 0);
    if (last.layers.capacity() < max_layers) {
        last.layers.clear();
        last.layers.reserve(max_layers + max_layers / 2);
    }
    blocks.follow(crowd);
    grow(block_seen, size_t(views.count) * blocks.blocks().count);
    listed.reserve(count);
    ordered.reserve(count);
    caches.reserve(count, crowd.templates(), may_throw(crowd));
    grow(rows, count);
    view_changes.reserve(count);
    grow(groups, crowd.group_count());
    if (may_throw(crowd)) {
        last.rows.reserve(rows.capacity());
        last.groups.reserve(groups.capacity());
    }
}

void Work::begin(const crowd::Crowd &crowd)
{
    can_undo = may_throw(crowd);
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
    caches.begin(can_undo);
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
           blocks.bytes() + view_changes.bytes() + caches.book_bytes() + caches.counters().arena_bytes;
}

}  // namespace claque::frame
