// A table whose rows keep their index while they are in use and are reused after they are freed. An id identifies one
// use of a row: once the row is freed, the id stays stale.
//
// Only `reserve` and `append` allocate. After a `reserve`, `take` and `free` cannot fail.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <new>
#include <type_traits>
#include <vector>

#include "lib/base/reserve.h"

namespace claque::base
{

struct SlotId {
    uint32_t index1 = 0;  // row + 1; 0: no row
    uint32_t generation = 0;
};

constexpr uint32_t no_slot = 0xffffffffu;

// A value with its row's generation and link. Assigning the value keeps both.
template <class T>
struct Slot : T {
    static constexpr uint32_t unlinked = no_slot - 1;

    uint32_t generation = 0;  // odd while the row is in use
    uint32_t next_free =
        unlinked;  // the row to take after this one; no_slot ends the chain; unlinked: not in the chain
};

// T is plain data. A free row holds T().
template <class T>
class SlotMap
{
    static_assert(std::is_trivially_copyable_v<T>, "rows are taken and freed without throwing");

public:
    // A row of this generation stays empty, so that no old id becomes valid again.
    static constexpr uint32_t retired = 0xfffffffeu;
    static constexpr uint32_t default_max_size = 1u << 28;

    explicit SlotMap(std::pmr::memory_resource *memory, uint32_t max_size = default_max_size)
        : slots_(memory), max_size_(max_size)
    {
    }

    // Makes room for this many calls of `take`. Throws std::bad_alloc and changes nothing then.
    void reserve(uint32_t count = 1)
    {
        if (count <= free_count_) return;
        if (!has_room(count)) throw std::bad_alloc();
        reserve_more(slots_, count - free_count_);
    }
    bool has_room(uint32_t count = 1) const { return count <= free_count_ + (max_size_ - size()); }

    // Takes the row that was freed last, or a new one at the end if none is free. Requires `reserve`.
    uint32_t take() noexcept
    {
        uint32_t row = first_free_;
        if (row == no_slot) {
            row = size();
            slots_.emplace_back();
        } else {
            first_free_ = slots_[row].next_free;
            slots_[row].next_free = Slot<T>::unlinked;
            --free_count_;
        }
        ++slots_[row].generation;
        ++used_count_;
        return row;
    }

    void free(uint32_t row) noexcept
    {
        slots_[row].T::operator=(T());
        ++slots_[row].generation;
        --used_count_;
        link_free(row);
    }

    T &operator[](uint32_t row) { return slots_[row]; }
    const T &operator[](uint32_t row) const { return slots_[row]; }
    const Slot<T> &slot(uint32_t row) const { return slots_[row]; }

    bool in_use(uint32_t row) const { return slots_[row].generation & 1; }
    SlotId id_of(uint32_t row) const { return {row + 1, slots_[row].generation}; }
    // The row of the id, or no_slot if the id is stale.
    uint32_t find(SlotId id) const
    {
        const uint32_t row = id.index1 - 1;
        const bool found = id.index1 != 0 && row < size() && slots_[row].generation == id.generation && in_use(row);
        return found ? row : no_slot;
    }

    uint32_t size() const { return static_cast<uint32_t>(slots_.size()); }  // rows, including free and retired ones
    uint32_t capacity() const { return static_cast<uint32_t>(slots_.capacity()); }  // grows in steps
    uint32_t max_size() const { return max_size_; }
    uint32_t used_count() const { return used_count_; }
    uint32_t free_count() const { return free_count_; }
    uint64_t bytes() const { return slots_.capacity() * sizeof(Slot<T>); }
    std::pmr::memory_resource *memory() const { return slots_.get_allocator().resource(); }

    // Free rows in the order in which they will be taken.
    template <class Body>
    void for_each_free(const Body &body) const
    {
        for (uint32_t row = first_free_; row != no_slot; row = slots_[row].next_free) body(row);
    }

    // Rebuilds a saved map: append all rows in order, then the free ones, the last one to be taken first.
    uint32_t append(uint32_t generation)
    {
        if (size() >= max_size_) throw std::bad_alloc();
        reserve_more(slots_);
        slots_.emplace_back();
        slots_.back().generation = generation;
        used_count_ += generation & 1;
        return size() - 1;
    }
    static bool can_be_free(uint32_t generation) { return !(generation & 1) && generation != retired; }
    // False if the row is in use, retired or already free; changes nothing then.
    bool link_free(uint32_t row) noexcept
    {
        Slot<T> &slot = slots_[row];
        if (!can_be_free(slot.generation) || slot.next_free != Slot<T>::unlinked) return false;
        slot.next_free = first_free_;
        first_free_ = row;
        ++free_count_;
        return true;
    }

private:
    std::pmr::vector<Slot<T>> slots_;
    uint32_t max_size_;
    uint32_t used_count_ = 0, free_count_ = 0;
    uint32_t first_free_ = no_slot;
};

}  // namespace claque::base
