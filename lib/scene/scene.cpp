// What a scene takes over from the crowd and from draw lists.
#include "lib/scene/scene.h"

#include <algorithm>
#include <cmath>

namespace claque::scene
{

using model::none;

namespace
{

// The tree is built anew after so many steps, and more in larger crowds: the cost of each then stays the same.
constexpr uint32_t build_from = 256;

// Several bitmaps of one size.
void grow(model::Array<base::Bitmap> &bitmaps, size_t count, uint32_t rows)
{
    bitmaps.reserve(count);
    while (bitmaps.size() < count) bitmaps.emplace_back(bitmaps.get_allocator().resource());
    for (base::Bitmap &bitmap : bitmaps) bitmap.reserve(rows);
}

template <class Column, class Value>
void grow(Column &column, size_t size, const Value &value)
{
    if (size > column.size()) column.resize(size, value);
}

uint64_t bytes_of(const model::Array<base::Bitmap> &bitmaps)
{
    uint64_t sum = base::held_bytes(bitmaps);
    for (const base::Bitmap &bitmap : bitmaps) sum += bitmap.bytes();
    return sum;
}

}  // namespace

Scene::Scene(std::pmr::memory_resource *memory, double spare)
    : spare_(spare),
      changes_(memory),
      tree_(memory),
      rows_(memory),
      masks_(memory),
      keys_(memory),
      members_(memory),
      leaves_(memory),
      known_(memory),
      movers_(memory),
      templates_(memory),
      texture_sets_(memory),
      levels_(memory),
      categories_(memory),
      order_(memory),
      shown_(memory)
{
}

void Scene::reserve(const crowd::Crowd &crowd)
{
    const uint32_t rows = std::max(crowd.row_capacity(), static_cast<uint32_t>(rows_.size()));
    size_t sets = 0, levels = 0;
    for (const model::Template *tmpl : crowd.templates()) {
        sets = std::max(sets, size_t(tmpl->texture_set_count()));
        levels = std::max(levels, tmpl->levels.size());
    }
    changes_.rows.reserve(rows);
    changes_.groups.reserve(crowd.tables.groups.all.capacity());
    tree_.reserve(rows);
    known_.reserve(rows), movers_.reserve(rows);
    grow(templates_, crowd.templates().count, rows);
    grow(texture_sets_, sets, rows);
    grow(levels_, levels, rows);
    for (base::Bitmap &category : categories_)
        if (category.count() > 0) category.reserve(rows);
    for (Shown &shown : shown_) grow(shown.items, rows, none);
    grow(members_, crowd.tables.groups.all.capacity(), none);
    grow(leaves_, rows, none);
    grow(masks_, rows, 0u);
    grow(keys_, rows, std::nan(""));
    grow(rows_, rows, Row());
}

void Scene::take_over(const crowd::Crowd &crowd, double time_s) noexcept
{
    time_s_ = time_s;
    drawn_ = false;
    placed_before_ = placed_;
    if (changes_.everything) tree_.dissolve();
    if (changes_.everything) renew(crowd);
    else {
        changes_.rows.for_each([&](uint32_t row) { take(crowd, row); });
        changes_.groups.for_each([&](uint32_t group) {
            for (uint32_t row = members_[group]; row != none; row = rows_[row].next) place(crowd, row);
        });
    }
    changes_.clear();
    movers_.for_each([&](uint32_t row) {
        if (!(std::fabs(time_s - rows_[row].placed_s) <= rows_[row].valid_s)) place(crowd, row);
    });
    if (!tree_.is_loose() && placed_ - placed_when_built_ <= build_from + 2 * uint64_t(known_.count())) return;
    if (!tree_.is_loose()) tree_.dissolve();
    build_tree();
}

// Before a leaf is made or moved. Where many are, the tree is built anew behind them, which costs less for each.
void Scene::count_place() noexcept
{
    ++placed_;
    if (!tree_.is_loose() && placed_ - placed_before_ > build_from + known_.count() / 8) tree_.dissolve();
}

void Scene::build_tree() noexcept
{
    uint32_t count = 0;
    for (const Row &row : rows_)
        if (row.node != none) leaves_[count++] = row.node;
    tree_.build(leaves_.data(), count);
    placed_when_built_ = placed_;
}

// After a restore: individuals with the same id keep what the host gave them, no level has been shown.
void Scene::renew(const crowd::Crowd &crowd) noexcept
{
    for (uint32_t row = 0; row < rows_.size(); ++row) {
        set_in(levels_, rows_[row].level, none, row);
        if (row < crowd.row_count()) take(crowd, row);
        else if (rows_[row].generation != 0) forget(row);
    }
}

// Makes a row that of the individual that the crowd has there now.
void Scene::claim(const crowd::Crowd &crowd, uint32_t row) noexcept
{
    if (rows_[row].generation != 0 && rows_[row].generation != crowd.actor(row).generation) forget(row);
    if (crowd.alive(row)) rows_[row].generation = crowd.actor(row).generation;
}

void Scene::settle(const crowd::Crowd &crowd) noexcept
{
    for (uint32_t row = 0; row < rows_.size(); ++row) {
        if (!changes_.everything && !changes_.rows.has(row)) continue;
        if (row < crowd.row_count()) claim(crowd, row);
        else if (rows_[row].generation != 0) forget(row);
    }
}

void Scene::take(const crowd::Crowd &crowd, uint32_t row) noexcept
{
    claim(crowd, row);
    if (!crowd.alive(row)) return;
    Row &own = rows_[row];
    known_.insert(row);
    set_in(templates_, own.tmpl, crowd.actor(row).tmpl, row);
    set_in(texture_sets_, own.texture_set, crowd.actor(row).texture_set, row);
    link_group(row, crowd.group_of(row));
    if (crowd.follows().of(row)) movers_.insert(row);
    else movers_.erase(row);
    place(crowd, row);
}

void Scene::forget(uint32_t row) noexcept
{
    Row &own = rows_[row];
    if (own.node != none) tree_.erase(own.node);
    known_.erase(row), movers_.erase(row);
    set_in(templates_, own.tmpl, none, row);
    set_in(texture_sets_, own.texture_set, none, row);
    set_in(levels_, own.level, none, row);
    link_group(row, none);
    set_mask(row, 0);
    if (!std::isnan(keys_[row])) order_.erase({keys_[row], row});
    keys_[row] = std::nan("");
    own = Row();
}

// A small move stays in its box, and gets a box with room to spare when it leaves it. What stands still has none.
void Scene::place(const crowd::Crowd &crowd, uint32_t row) noexcept
{
    Row &own = rows_[row];
    Bounds bounds;
    if (!bounds_at(crowd, row, time_s_, spare_, bounds)) {
        if (own.node != none) tree_.erase(own.node);
        own.node = none;
        return;
    }
    own.placed_s = time_s_, own.valid_s = bounds.valid_s;
    if (own.node == none) {
        count_place();
        own.node = tree_.insert(row, bounds.leaf);
        return;
    }
    const Tree::Node &is = tree_.node(own.node);
    const bool same = is.reach == bounds.leaf.reach && is.speed == bounds.leaf.speed;
    const bool moves_itself = bounds.valid_s < HUGE_VAL;
    if (same && !moves_itself && is.box.holds(bounds.leaf.box)) return;
    if (!moves_itself && !is.box.holds(bounds.tight))
        for (int k = 0; k < 3; ++k) {
            bounds.leaf.box.low[k] = -rounded_up(spare_ - double(bounds.leaf.box.low[k]));
            bounds.leaf.box.high[k] = rounded_up(spare_ + double(bounds.leaf.box.high[k]));
        }
    count_place();
    tree_.move(own.node, bounds.leaf);
}

void Scene::link_group(uint32_t row, uint32_t group) noexcept
{
    Row &own = rows_[row];
    if (own.group == group) return;
    if (own.group != none) {
        if (own.next != none) rows_[own.next].before = own.before;
        if (own.before != none) rows_[own.before].next = own.next;
        else members_[own.group] = own.next;
    }
    own.group = group, own.next = own.before = none;
    if (group == none) return;
    own.next = members_[group];
    if (own.next != none) rows_[own.next].before = row;
    members_[group] = row;
}

void Scene::set_in(model::Array<base::Bitmap> &bitmaps, uint32_t &of, uint32_t now, uint32_t row) noexcept
{
    if (of == now) return;
    if (of != none) bitmaps[of].erase(row);
    of = now;
    if (now != none) bitmaps[now].insert(row);
}

uint64_t Scene::bytes() const
{
    uint64_t sum = base::held_bytes(rows_, masks_, keys_, members_, leaves_, shown_) + tree_.bytes() +
                   changes_.bytes() + known_.bytes() + movers_.bytes() + bytes_of(templates_) +
                   bytes_of(texture_sets_) + bytes_of(levels_) + bytes_of(categories_) +
                   order_.size() * order_node_bytes;
    for (const Shown &shown : shown_) sum += base::held_bytes(shown.items);
    return sum;
}

}  // namespace claque::scene
