#include "animcache/block_pool.h"

#include <algorithm>
#include <cstring>
#include <functional>

#include "lib/base/held_bytes.h"

namespace claque::animcache
{

namespace
{

void set_next(float *block, float *next) { std::memcpy(block, &next, sizeof next); }

float *next_of(const float *block)
{
    float *next;
    std::memcpy(&next, block, sizeof next);
    return next;
}

}  // namespace

BlockPool::BlockPool(std::pmr::memory_resource *memory, uint64_t budget_bytes)
    : memory_(memory), budget_bytes_(budget_bytes), size_classes_(memory)
{
}

BlockPool::~BlockPool()
{
    for (const SizeClass &size_class : size_classes_)
        for (const Slab &slab : size_class.slabs)
            memory_->deallocate(slab.memory, slab.blocks * size_class.bytes, alignment);
}

uint64_t BlockPool::book_bytes() const
{
    uint64_t sum = base::held_bytes(size_classes_);
    for (const SizeClass &size_class : size_classes_) sum += base::held_bytes(size_class.slabs);
    return sum;
}

BlockPool::SizeClass *BlockPool::size_class_of(size_t bytes)
{
    for (SizeClass &size_class : size_classes_)
        if (size_class.bytes == bytes) return &size_class;
    return nullptr;
}

float *BlockPool::take_from(SizeClass &size_class, size_t index)
{
    Slab &slab = size_class.slabs[index];
    float *block = slab.free;
    slab.free = next_of(block);
    ++slab.used;
    used_bytes_ += size_class.bytes;
    return block;
}

float *BlockPool::allocate_from_slabs(size_t bytes)
{
    SizeClass *size_class = size_class_of(rounded_size(bytes));
    if (!size_class) return nullptr;
    for (; size_class->first_free < size_class->slabs.size(); ++size_class->first_free)
        if (size_class->slabs[size_class->first_free].free) return take_from(*size_class, size_class->first_free);
    return nullptr;
}

// All that may fail comes before the slab's allocation, and that comes before the slab is registered.
void BlockPool::add_slab(size_t bytes, uint32_t blocks)
{
    SizeClass *size_class = size_class_of(bytes);
    if (!size_class) size_class = &size_classes_.emplace_back(bytes, memory_);
    if (size_class->slabs.size() == size_class->slabs.capacity())
        size_class->slabs.reserve(2 * size_class->slabs.size() + 8);
    Slab slab;
    slab.memory = static_cast<std::byte *>(memory_->allocate(blocks * bytes, alignment));
    slab.blocks = blocks;
    for (uint32_t i = blocks; i-- > 0;) {
        float *block = reinterpret_cast<float *>(slab.memory + i * bytes);
        set_next(block, slab.free);
        slab.free = block;
    }
    reserved_bytes_ += blocks * bytes;
    const auto position = std::upper_bound(size_class->slabs.begin(), size_class->slabs.end(), slab.memory,
                                           [](const std::byte *memory, const Slab &other) {
                                               return std::less<const std::byte *>()(memory, other.memory);
                                           });
    size_class->first_free =
        std::min(size_class->first_free, static_cast<size_t>(position - size_class->slabs.begin()));
    size_class->slabs.insert(position, slab);
}

float *BlockPool::allocate_new_slab(size_t bytes) noexcept
{
    constexpr uint64_t max_blocks = 64, min_slabs = 256;  // keeps a slab a small share of the budget
    const size_t stride = rounded_size(bytes);
    const uint64_t fit = (budget_bytes_ - reserved_bytes_) / stride;
    const uint64_t wish = std::clamp<uint64_t>(budget_bytes_ / min_slabs / stride, 1, max_blocks);
    if (fit == 0) return nullptr;
    try {
        add_slab(stride, static_cast<uint32_t>(std::min(fit, wish)));
    } catch (...) {
        return nullptr;
    }
    return allocate_from_slabs(bytes);
}

void BlockPool::deallocate(float *block, size_t bytes)
{
    SizeClass &size_class = *size_class_of(rounded_size(bytes));
    const std::byte *address = reinterpret_cast<const std::byte *>(block);
    const auto after = std::upper_bound(
        size_class.slabs.begin(), size_class.slabs.end(), address,
        [](const std::byte *at, const Slab &slab) { return std::less<const std::byte *>()(at, slab.memory); });
    Slab &slab = *(after - 1);
    set_next(block, slab.free);
    slab.free = block;
    --slab.used;
    used_bytes_ -= size_class.bytes;
    size_class.first_free = std::min(size_class.first_free, static_cast<size_t>(after - 1 - size_class.slabs.begin()));
}

bool BlockPool::trim()
{
    const uint64_t before = reserved_bytes_;
    for (SizeClass &size_class : size_classes_) {
        for (const Slab &slab : size_class.slabs) {
            if (slab.used > 0) continue;
            memory_->deallocate(slab.memory, slab.blocks * size_class.bytes, alignment);
            reserved_bytes_ -= slab.blocks * size_class.bytes;
        }
        size_class.slabs.erase(std::remove_if(size_class.slabs.begin(), size_class.slabs.end(),
                                              [](const Slab &slab) { return slab.used == 0; }),
                               size_class.slabs.end());
        size_class.first_free = 0;
    }
    return reserved_bytes_ < before;
}

}  // namespace claque::animcache
