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

template <class Array>
void grow(Array &array, size_t count)
{
    if (array.size() < count) array.resize(count);
}

void reserve_view(View &view, const crowd::Crowd &crowd)
{
    view.list.items.reserve(crowd.row_capacity());
    view.hooked.reserve(crowd.hooked_count());
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
      eyes(memory),
      block_seen(memory),
      tested(memory),
      passed(memory),
      candidates(memory),
      sights(memory),
      visible(memory),
      layers(memory),
      dofs(memory),
      behaving(memory),
      listed(memory),
      ordered(memory)
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
    grow(sights, size_t(views.count) * count);
    grow(tested, count);
    grow(candidates, count);
    grow(visible, count);
    grow(behaving, count);
    dofs_each = 0;
    for (const model::Template *tmpl : crowd.templates())
        dofs_each = std::max(dofs_each, static_cast<uint32_t>(tmpl->rig.dofs.size()));
    if (crowd.behaviours().mechanism_count() > 0) grow(dofs, (size_t(count) + 1) * dofs_each);
    const size_t max_layers = size_t(crowd.layers().slot_count()) * pose::max_layers +
                              (crowd.behaviours().any_blend() ? 2 * size_t(count) : 0);
    if (layers.capacity() < max_layers) {
        layers.clear();
        layers.reserve(max_layers + max_layers / 2);
    }
    blocks.follow(crowd);
    grow(block_seen, size_t(views.count) * blocks.blocks().count);
    listed.reserve(count);
    ordered.reserve(count);
    caches.reserve(count, crowd.templates());
    grow(rows, count);
    grow(groups, crowd.group_count());
}

uint64_t Work::bytes() const
{
    return base::held_bytes(rows, groups, eyes, block_seen, tested, passed, candidates, sights, visible, layers, dofs,
                            behaving, listed, ordered) +
           blocks.bytes() + caches.book_bytes() + caches.counters().arena_bytes;
}

}  // namespace claque::frame
