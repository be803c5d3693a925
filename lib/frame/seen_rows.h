// Which rows of a crowd have ever passed the first cull phase. Arrays that updates keep have a slot for each of these
// alone, so that the others take no room in them.
#pragma once

#include "lib/base/held_bytes.h"
#include "lib/crowd/crowd.h"

namespace claque::frame
{

class SeenRows
{
public:
    explicit SeenRows(std::pmr::memory_resource *memory) : slots_(memory) {}

    // May throw std::bad_alloc.
    void reserve(uint32_t row_capacity)
    {
        if (slots_.size() < row_capacity) slots_.resize(row_capacity, model::none);
    }
    // Requires `reserve`. A row keeps its slot, whatever individual it has later.
    uint32_t insert(uint32_t row) noexcept
    {
        if (slots_[row] == model::none) slots_[row] = count_++;
        return slots_[row];
    }
    uint32_t slot_of(uint32_t row) const { return row < slots_.size() ? slots_[row] : model::none; }
    uint32_t count() const { return count_; }
    uint64_t bytes() const { return base::held_bytes(slots_); }

private:
    std::pmr::vector<uint32_t> slots_;  // by row; none: never passed
    uint32_t count_ = 0;
};

}  // namespace claque::frame
