// Working memory for a fixed number of tasks, grown before a frame begins so that no task allocates. The number of
// tasks does not depend on the number of threads, so that a task uses the same memory on every machine.
#pragma once

#include "animcache/evaluate.h"

namespace claque::animcache
{

class ScratchPool
{
public:
    ScratchPool(std::pmr::memory_resource *memory, uint32_t slices);
    void reserve(const Sizes &sizes);  // std::bad_alloc: unchanged
    Scratch slice(uint32_t index);
    uint64_t bytes() const;
    uint32_t slice_count() const { return slices_; }

private:
    uint32_t slices_;
    Sizes sizes_;
    std::pmr::vector<math::Trs> locals_;
    std::pmr::vector<math::Columns> globals_;
    std::pmr::vector<float> floats_, palettes_, spares_;
};

}  // namespace claque::animcache
