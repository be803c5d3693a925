#include "lib/crowd/colours.h"

namespace claque::crowd
{

ColourTable::ColourTable(std::pmr::memory_resource *memory, uint32_t zone_count)
    : stride_(3 * zone_count), chunks_(memory), free_(memory)
{
}

ColourTable::~ColourTable()
{
    for (uint8_t *chunk : chunks_)
        chunks_.get_allocator().resource()->deallocate(chunk, size_t(chunk_rows) * stride_, 1);
}

uint32_t ColourTable::take()
{
    if (!free_.empty()) {
        const uint32_t slot = free_.back();
        free_.pop_back();
        return slot;
    }
    if (used_ == chunks_.size() * chunk_rows) {
        free_.reserve((chunks_.size() + 1) * chunk_rows);
        if (chunks_.size() == chunks_.capacity()) chunks_.reserve(2 * chunks_.size() + 4);
        chunks_.push_back(
            static_cast<uint8_t *>(chunks_.get_allocator().resource()->allocate(size_t(chunk_rows) * stride_, 1)));
    }
    return used_++;
}

void ColourTable::give_back(uint32_t slot) noexcept { free_.push_back(slot); }

uint64_t ColourTable::bytes() const
{
    return uint64_t(chunks_.size()) * chunk_rows * stride_ + chunks_.capacity() * sizeof(uint8_t *) +
           free_.capacity() * sizeof(uint32_t);
}

}  // namespace claque::crowd
