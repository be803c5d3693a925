// The individuals of a crowd in several indices at once (S2 3.1, the multi-view scene): by id, by what they show, by
// the host's categories and keys, and by place. Edits of the crowd only mark what they change; an update takes it over.
// Between updates every question is still answered exactly: what is marked is tested one by one.
//
// reserve() may throw; then take_over() cannot fail. Questions (questions.h) change nothing and may run side by side.
#pragma once

#include "lib/base/bitmap.h"
#include "lib/crowd/crowd.h"
#include "lib/draw/draw_list.h"
#include "lib/scene/filter.h"
#include "lib/scene/order.h"
#include "lib/scene/place.h"
#include "lib/scene/tree.h"

namespace claque::scene
{

// One individual in the index.
struct Row {
    uint32_t generation = 0;      // of the individual that the rest is of; 0: none
    uint32_t node = model::none;  // of the tree; none: its place is not finite
    uint32_t tmpl = model::none, texture_set = model::none, level = model::none;
    uint32_t group = model::none, next = model::none, before = model::none;  // list of the group's members
    double placed_s = 0, valid_s = 0;                                        // as in Bounds
};

// The draw list's item of each row, as of a view's last update. Entries may be of earlier lists.
struct Shown {
    Shown(std::pmr::memory_resource *memory, const void *of) : view(of), items(memory) {}
    const void *view;
    model::Array<uint32_t> items;
};

class Scene
{
public:
    // spare: world units by which boxes of what moves are larger than they have to be
    Scene(std::pmr::memory_resource *memory, double spare);
    Scene(const Scene &) = delete;
    Scene &operator=(const Scene &) = delete;

    crowd::Changes &changes() { return changes_; }
    const crowd::Changes &changes() const { return changes_; }

    // Makes room for all that take_over and show need. Throws std::bad_alloc; the scene answers as before then.
    void reserve(const crowd::Crowd &crowd);
    void reserve_view(const crowd::Crowd &crowd, const void *view);
    // Takes over all that is marked; the index is then that of this time.
    void take_over(const crowd::Crowd &crowd, double time_s) noexcept;
    // Notes which levels a draw list shows. The list is one of an update at the time of the last take_over.
    void show(const crowd::Crowd &crowd, const void *view, const draw::DrawList &list) noexcept;
    void set_drawn(bool drawn) noexcept { drawn_ = drawn; }
    void forget_view(const void *view) noexcept;
    // Before the crowd's state is replaced: ends what the host gave individuals that are no more.
    void settle(const crowd::Crowd &crowd) noexcept;

    // All or none; may throw base::Error (CLQ_STALE_ID) or std::bad_alloc.
    void set_categories(const crowd::Crowd &crowd, const crowd::Id *ids, uint32_t count, uint64_t categories);
    void set_keys(const crowd::Crowd &crowd, const crowd::Id *ids, const double *keys, uint32_t count);  // NaN: none

    // What is known of an individual, taken over or not.
    bool knows(const crowd::Crowd &crowd, uint32_t row) const
    {
        return row < rows_.size() && row < crowd.row_count() && crowd.alive(row) &&
               rows_[row].generation == crowd.actor(row).generation;
    }
    uint64_t categories_of(const crowd::Crowd &crowd, uint32_t row) const
    {
        return knows(crowd, row) ? masks_[row] : 0;
    }
    double key_of(const crowd::Crowd &crowd, uint32_t row) const;     // NaN: none
    uint32_t level_of(const crowd::Crowd &crowd, uint32_t row) const  // none: no update has shown it
    {
        return knows(crowd, row) && !changes_.everything ? rows_[row].level : model::none;
    }
    bool matches(const crowd::Crowd &crowd, uint32_t row, const Filter &filter) const;
    // Whether the index has something else than the crowd.
    bool is_marked(uint32_t row) const
    {
        return changes_.rows.has(row) || (changes_.groups.count() > 0 && rows_[row].group != model::none &&
                                          changes_.groups.has(rows_[row].group));
    }
    // Calls body(row) for every marked row. Needs changes().everything to be false.
    template <class Body>
    void for_each_marked(const Body &body) const
    {
        changes_.rows.for_each(body);
        changes_.groups.for_each([&](uint32_t group) {
            for (uint32_t row = group < members_.size() ? members_[group] : model::none; row != model::none;
                 row = rows_[row].next)
                if (!changes_.rows.has(row)) body(row);
        });
    }

    const Tree &tree() const { return tree_; }
    const Order &order() const { return order_; }
    double time_s() const { return time_s_; }                // of the last take_over
    bool is_drawn() const { return drawn_; }                 // whether the tree is that of the draw lists
    uint32_t item_of(const void *view, uint32_t row) const;  // may be of an earlier list; none: unknown
    uint32_t known_count() const { return known_.count(); }
    uint32_t mover_count() const { return movers_.count(); }
    uint64_t placed_count() const { return placed_; }  // leaves made or moved since the beginning
    uint64_t bytes() const;

private:
    friend class Chosen;

    void renew(const crowd::Crowd &crowd) noexcept;
    void build_tree() noexcept;
    void count_place() noexcept;
    void take(const crowd::Crowd &crowd, uint32_t row) noexcept;
    void claim(const crowd::Crowd &crowd, uint32_t row) noexcept;
    void forget(uint32_t row) noexcept;
    void place(const crowd::Crowd &crowd, uint32_t row) noexcept;
    void link_group(uint32_t row, uint32_t group) noexcept;
    void set_in(model::Array<base::Bitmap> &bitmaps, uint32_t &of, uint32_t now, uint32_t row) noexcept;
    void set_mask(uint32_t row, uint64_t categories) noexcept;

    double spare_, time_s_ = 0;
    bool drawn_ = false;
    uint64_t placed_ = 0, placed_when_built_ = 0, placed_before_ = 0;  // before this take_over
    crowd::Changes changes_;
    Tree tree_;
    model::Array<Row> rows_;
    model::Array<uint64_t> masks_;    // categories, by row
    model::Array<double> keys_;       // by row; NaN: none
    model::Array<uint32_t> members_;  // by group: its first member
    model::Array<uint32_t> leaves_;   // scratch of build_tree
    base::Bitmap known_, movers_;     // rows in the index; of these, on tracks
    model::Array<base::Bitmap> templates_, texture_sets_, levels_, categories_;
    Order order_;
    model::Array<Shown> shown_;
};

}  // namespace claque::scene
