// The colours of the individuals of one template: 8-bit RGB, a row of zone_count each. Rows are in chunks that never
// move, so that a new individual does not copy the others' colours.
#pragma once

#include "lib/base/slot_map.h"
#include "lib/model/template.h"

namespace claque::crowd
{

class ColourTable
{
public:
    ColourTable(std::pmr::memory_resource *memory, uint32_t zone_count);

    void reserve(uint32_t count = 1);  // room for this many calls of `take`; std::bad_alloc leaves the table unchanged
    uint32_t take() noexcept { return slots_.take(); }
    void give_back(uint32_t slot) noexcept { slots_.free(slot); }
    uint8_t *row(uint32_t slot) { return chunks_[slot / chunk_rows].data() + at(slot); }
    const uint8_t *row(uint32_t slot) const { return chunks_[slot / chunk_rows].data() + at(slot); }
    uint32_t stride() const { return stride_; }
    uint64_t bytes() const;
    size_t colour_bytes() const { return size_t(slots_.size()) * stride_; }  // of all slots, including free ones

private:
    static constexpr uint32_t chunk_rows = 256;
    struct NoValue {
    };

    size_t at(uint32_t slot) const { return size_t(slot % chunk_rows) * stride_; }

    uint32_t stride_;  // bytes
    base::SlotMap<NoValue> slots_;
    model::Array<model::Array<uint8_t>> chunks_;
};

}  // namespace claque::crowd
