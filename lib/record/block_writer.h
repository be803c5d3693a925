// The block that is being written: entries one after the other, in memory until the block is sealed.
#pragma once

#include "lib/model/template.h"
#include "lib/record/call_fields.h"

namespace claque::record
{

class BlockWriter : public base::Sink
{
public:
    explicit BlockWriter(std::pmr::memory_resource *memory) : bytes_(memory) { clear(); }

    // An entry: `body` gives its fields to the archive. May throw std::bad_alloc, or base::Error (CLQ_LIMIT) where it
    // is larger than a block can be.
    template <class Body>
    void entry(Kind kind, const Body &body)
    {
        const size_t begin = bytes_.size();
        open(kind);
        crowd::Writer out(*this);
        body(out);
        out.flush();
        close(begin);
    }
    template <class Call>
    void call(const Call &call)
    {
        entry(Call::kind, [&](crowd::Writer &out) { walk(out, call); });
    }
    // crowd_set_transforms: hosts call it in every frame, so it has a faster way.
    void transforms(const clq_actor *actors, const clq_transform *places, uint32_t count);

    void take(const uint8_t *bytes, size_t count) override { bytes_.insert(bytes_.end(), bytes, bytes + count); }

    size_t contents_size() const { return bytes_.size() - block_header_bytes; }
    const uint8_t *contents() const { return bytes_.data() + block_header_bytes; }
    uint64_t number() const { return number_; }
    uint64_t calls() const { return calls_; }  // entries that are calls, so far
    uint64_t held_bytes() const { return bytes_.capacity(); }
    const model::Array<uint8_t> &sealed();  // with its header; then clear()
    void clear();

private:
    void open(Kind kind);
    void close(size_t begin);

    model::Array<uint8_t> bytes_;
    uint64_t number_ = 0, calls_ = 0;
};

// Of one element of crowd_set_transforms.
constexpr size_t placed_bytes = 8 + 24 + 16 + 4;

}  // namespace claque::record
