// What a host gives individuals: categories, and a key of its own order; and what draw lists show of them.
#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/scene/scene.h"

namespace claque::scene
{

using model::none;

void Scene::set_mask(uint32_t row, uint64_t categories) noexcept
{
    for (uint64_t left = masks_[row] & ~categories; left != 0; left &= left - 1)
        categories_[base::lowest_bit(left)].erase(row);
    for (uint64_t left = categories & ~masks_[row]; left != 0; left &= left - 1)
        categories_[base::lowest_bit(left)].insert(row);
    masks_[row] = categories;
}

void Scene::set_categories(const crowd::Crowd &crowd, const crowd::Id *ids, uint32_t count, uint64_t categories)
{
    for (uint32_t i = 0; i < count; ++i) crowd.row_of(ids[i]);
    reserve(crowd);
    const uint32_t rows = static_cast<uint32_t>(rows_.size());
    if (categories != 0) {
        categories_.reserve(category_count);
        while (categories_.size() < category_count) categories_.emplace_back(rows_.get_allocator().resource());
        for (uint64_t left = categories; left != 0; left &= left - 1) categories_[base::lowest_bit(left)].reserve(rows);
    }

    // Commit: nothing below can fail.
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t row = ids[i].index1 - 1;
        claim(crowd, row);
        set_mask(row, categories);
    }
}

void Scene::set_keys(const crowd::Crowd &crowd, const crowd::Id *ids, const double *keys, uint32_t count)
{
    for (uint32_t i = 0; i < count; ++i) crowd.row_of(ids[i]);
    reserve(crowd);
    // Nodes for individuals that have none yet.
    Order spare(order_.get_allocator());
    for (uint32_t i = 0; i < count; ++i)
        if (!std::isnan(keys[i]) && std::isnan(key_of(crowd, ids[i].index1 - 1))) spare.insert({0, i});

    // Commit: nothing below can fail.
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t row = ids[i].index1 - 1;
        claim(crowd, row);
        const bool was_in = !std::isnan(keys_[row]), is_in = !std::isnan(keys[i]);
        if (!was_in && !is_in) continue;
        Order::node_type node = was_in ? order_.extract(Keyed{keys_[row], row}) : spare.extract(spare.begin());
        keys_[row] = keys[i];
        node.value() = is_in ? Keyed{keys[i], row} : Keyed{0, i};
        Order &to = is_in ? order_ : spare;
        to.insert(to.end(), std::move(node));
    }
}

double Scene::key_of(const crowd::Crowd &crowd, uint32_t row) const
{
    return knows(crowd, row) ? keys_[row] : std::nan("");
}

bool Scene::matches(const crowd::Crowd &crowd, uint32_t row, const Filter &filter) const
{
    if (!crowd.alive(row)) return false;
    if (filter.tmpl && &crowd.template_of(row) != filter.tmpl) return false;
    if (filter.texture_set != none && crowd.actor(row).texture_set != filter.texture_set) return false;
    if (filter.level != none && level_of(crowd, row) != filter.level) return false;
    const uint64_t mask = categories_of(crowd, row);
    return (filter.any_of == 0 || (mask & filter.any_of) != 0) && (mask & filter.all_of) == filter.all_of &&
           (mask & filter.none_of) == 0;
}

void Scene::reserve_view(const crowd::Crowd &crowd, const void *view)
{
    const auto is = [view](const Shown &shown) { return shown.view == view; };
    if (std::none_of(shown_.begin(), shown_.end(), is)) {
        shown_.reserve(shown_.size() + 1);
        shown_.emplace_back(rows_.get_allocator().resource(), view);
    }
    reserve(crowd);
}

void Scene::show(const crowd::Crowd &crowd, const void *view, const draw::DrawList &list) noexcept
{
    const auto is = [view](const Shown &one) { return one.view == view; };
    const auto shown = std::find_if(shown_.begin(), shown_.end(), is);
    for (uint32_t i = 0; i < list.items.size(); ++i) {
        const draw::Item &item = list.items[i];
        const uint32_t row = item.actor_index;
        if (row >= crowd.row_count() || crowd.actor(row).generation != item.generation) continue;
        if (!item.shadow_only) set_in(levels_, rows_[row].level, item.level, row);
        if (shown != shown_.end()) shown->items[row] = i;
    }
}

void Scene::forget_view(const void *view) noexcept
{
    const auto is = [view](const Shown &shown) { return shown.view == view; };
    shown_.erase(std::remove_if(shown_.begin(), shown_.end(), is), shown_.end());
}

uint32_t Scene::item_of(const void *view, uint32_t row) const
{
    for (const Shown &shown : shown_)
        if (shown.view == view && row < shown.items.size()) return shown.items[row];
    return none;
}

}  // namespace claque::scene
