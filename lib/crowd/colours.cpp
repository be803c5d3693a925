#include "lib/crowd/colours.h"

namespace claque::crowd
{

ColourTable::ColourTable(std::pmr::memory_resource *memory, uint32_t zone_count)
    : stride_(3 * zone_count), slots_(memory), chunks_(memory)
{
}

void ColourTable::reserve(uint32_t count)
{
    slots_.reserve(count);
    const uint32_t rows = slots_.size() + (count > slots_.free_count() ? count - slots_.free_count() : 0);
    while (chunks_.size() * chunk_rows < rows) {
        base::reserve_more(chunks_);
        model::Array<uint8_t> chunk(size_t(chunk_rows) * stride_, slots_.memory());
        chunks_.push_back(std::move(chunk));
    }
}

uint64_t ColourTable::bytes() const
{
    return uint64_t(chunks_.size()) * chunk_rows * stride_ + chunks_.capacity() * sizeof(chunks_[0]) + slots_.bytes();
}

}  // namespace claque::crowd
