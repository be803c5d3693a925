#include "animcache/block_pool.h"

#include <algorithm>
#include <cstring>
#include <functional>

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
    : memory_(memory), budget_bytes_(budget_bytes), shelves_(memory)
{
}

BlockPool::~BlockPool()
{
    for (const Shelf &shelf : shelves_)
        for (const Slab &slab : shelf.slabs) memory_->deallocate(slab.memory, slab.blocks * shelf.bytes, alignment);
}

BlockPool::Shelf *BlockPool::shelf_of(size_t bytes)
{
    for (Shelf &shelf : shelves_)
        if (shelf.bytes == bytes) return &shelf;
    return nullptr;
}

float *BlockPool::take_from(Shelf &shelf, size_t index)
{
    Slab &slab = shelf.slabs[index];
    float *block = slab.free;
    slab.free = next_of(block);
    ++slab.used;
    used_bytes_ += shelf.bytes;
    return block;
}

float *BlockPool::take_free(size_t bytes)
{
    Shelf *shelf = shelf_of(taken_by(bytes));
    if (!shelf) return nullptr;
    for (; shelf->roomy < shelf->slabs.size(); ++shelf->roomy)
        if (shelf->slabs[shelf->roomy].free) return take_from(*shelf, shelf->roomy);
    return nullptr;
}

// Everything that may fail comes before the slab, and the slab before it is entered.
void BlockPool::add_slab(size_t bytes, uint32_t blocks)
{
    Shelf *shelf = shelf_of(bytes);
    if (!shelf) shelf = &shelves_.emplace_back(bytes, memory_);
    if (shelf->slabs.size() == shelf->slabs.capacity()) shelf->slabs.reserve(2 * shelf->slabs.size() + 8);
    Slab slab;
    slab.memory = static_cast<std::byte *>(memory_->allocate(blocks * bytes, alignment));
    slab.blocks = blocks;
    for (uint32_t i = blocks; i-- > 0;) {
        float *block = reinterpret_cast<float *>(slab.memory + i * bytes);
        set_next(block, slab.free);
        slab.free = block;
    }
    held_bytes_ += blocks * bytes;
    const auto place = std::upper_bound(shelf->slabs.begin(), shelf->slabs.end(), slab.memory,
                                        [](const std::byte *memory, const Slab &other) {
                                            return std::less<const std::byte *>()(memory, other.memory);
                                        });
    shelf->roomy = std::min(shelf->roomy, static_cast<size_t>(place - shelf->slabs.begin()));
    shelf->slabs.insert(place, slab);
}

float *BlockPool::take_new(size_t bytes) noexcept
{
    constexpr uint64_t most_blocks = 64, least_slabs = 256;  // so that a slab is a small share of the budget
    const size_t stride = taken_by(bytes);
    const uint64_t fit = (budget_bytes_ - held_bytes_) / stride;
    const uint64_t wish = std::clamp<uint64_t>(budget_bytes_ / least_slabs / stride, 1, most_blocks);
    if (fit == 0) return nullptr;
    try {
        add_slab(stride, static_cast<uint32_t>(std::min(fit, wish)));
    } catch (...) {
        return nullptr;
    }
    return take_free(bytes);
}

void BlockPool::give(float *block, size_t bytes)
{
    Shelf &shelf = *shelf_of(taken_by(bytes));
    const std::byte *address = reinterpret_cast<const std::byte *>(block);
    const auto after = std::upper_bound(
        shelf.slabs.begin(), shelf.slabs.end(), address,
        [](const std::byte *at, const Slab &slab) { return std::less<const std::byte *>()(at, slab.memory); });
    Slab &slab = *(after - 1);
    set_next(block, slab.free);
    slab.free = block;
    --slab.used;
    used_bytes_ -= shelf.bytes;
    shelf.roomy = std::min(shelf.roomy, static_cast<size_t>(after - 1 - shelf.slabs.begin()));
}

bool BlockPool::trim()
{
    const uint64_t before = held_bytes_;
    for (Shelf &shelf : shelves_) {
        for (const Slab &slab : shelf.slabs) {
            if (slab.used > 0) continue;
            memory_->deallocate(slab.memory, slab.blocks * shelf.bytes, alignment);
            held_bytes_ -= slab.blocks * shelf.bytes;
        }
        shelf.slabs.erase(
            std::remove_if(shelf.slabs.begin(), shelf.slabs.end(), [](const Slab &slab) { return slab.used == 0; }),
            shelf.slabs.end());
        shelf.roomy = 0;
    }
    return held_bytes_ < before;
}

}  // namespace claque::animcache
