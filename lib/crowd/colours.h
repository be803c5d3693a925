// The colours of the individuals of one template: 8-bit RGB, a row of zone_count each, in chunks that never move: a
// new individual's colours cost no copy of the others'.
#pragma once

#include "lib/model/template.h"

namespace claque::crowd
{

class ColourTable
{
public:
    ColourTable(std::pmr::memory_resource *memory, uint32_t zone_count);
    ColourTable(ColourTable &&other) noexcept = default;
    ColourTable &operator=(ColourTable &&) = delete;
    ~ColourTable();

    uint32_t take();  // a slot; std::bad_alloc leaves the table as it was
    void give_back(uint32_t slot) noexcept;
    uint8_t *row(uint32_t slot) const { return chunks_[slot / chunk_rows] + size_t(slot % chunk_rows) * stride_; }
    uint32_t stride() const { return stride_; }
    uint64_t bytes() const;
    size_t colour_bytes() const { return size_t(used_) * stride_; }  // of all slots that ever were taken

private:
    static constexpr uint32_t chunk_rows = 256;
    uint32_t stride_;  // bytes
    uint32_t used_ = 0;
    std::pmr::vector<uint8_t *> chunks_;
    std::pmr::vector<uint32_t> free_;  // as long as all chunks have rows, so that giving back cannot fail
};

}  // namespace claque::crowd
