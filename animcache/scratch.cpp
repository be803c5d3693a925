#include "animcache/scratch.h"

#include <algorithm>

#include "lib/base/held_bytes.h"

namespace claque::animcache
{

ScratchPool::ScratchPool(std::pmr::memory_resource *memory, uint32_t slices)
    : slices_(slices), locals_(memory), globals_(memory), floats_(memory), palettes_(memory), spares_(memory)
{
}

void ScratchPool::reserve(const Sizes &sizes)
{
    Sizes wanted = sizes_;
    wanted.grow_to(sizes);
    // If a later one fails to grow, the earlier ones are larger than needed, which is harmless.
    locals_.resize(std::max(locals_.size(), slices_ * wanted.nodes));
    globals_.resize(std::max(globals_.size(), slices_ * wanted.nodes));
    floats_.resize(std::max(floats_.size(), slices_ * wanted.scratch_floats));
    palettes_.resize(std::max(palettes_.size(), slices_ * wanted.palette_floats));
    spares_.resize(std::max(spares_.size(), slices_ * wanted.spare_floats));
    sizes_ = wanted;
}

uint64_t ScratchPool::bytes() const { return base::held_bytes(locals_, globals_, floats_, palettes_, spares_); }

Scratch ScratchPool::slice(uint32_t index)
{
    return {locals_.data() + index * sizes_.nodes,
            globals_.data() + index * sizes_.nodes,
            floats_.data() + index * sizes_.scratch_floats,
            palettes_.data() + index * sizes_.palette_floats,
            sizes_.spare_floats ? spares_.data() + index * sizes_.spare_floats : nullptr,
            &sizes_};
}

}  // namespace claque::animcache
