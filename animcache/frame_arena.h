// Memory of one update: palettes and vertices that no cache keeps. reset() at the next update frees all of it but keeps
// the chunks, so that similar updates allocate nothing from the host.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "lib/base/held_bytes.h"

namespace claque::animcache
{

class FrameArena
{
public:
    explicit FrameArena(std::pmr::memory_resource *memory) : memory_(memory), chunks_(memory) {}
    ~FrameArena();  // gives all memory back
    FrameArena(const FrameArena &) = delete;
    FrameArena &operator=(const FrameArena &) = delete;

    static constexpr size_t alignment = 64;  // no two individuals share a cache line

    void reset();                                                // frees all blocks
    float *take(size_t bytes) noexcept;                          // null: the host refuses
    uint64_t used_bytes() const { return used_bytes_; }          // since the last reset
    uint64_t reserved_bytes() const { return reserved_bytes_; }  // of all chunks
    uint64_t book_bytes() const { return base::held_bytes(chunks_); }

private:
    struct Chunk {
        std::byte *memory = nullptr;
        size_t bytes = 0;
    };
    void add_chunk(size_t bytes);

    std::pmr::memory_resource *memory_;
    std::pmr::vector<Chunk> chunks_;
    size_t chunk_ = 0, offset_ = 0;  // of the next block
    uint64_t used_bytes_ = 0, reserved_bytes_ = 0;
};

}  // namespace claque::animcache
