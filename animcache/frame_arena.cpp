#include "animcache/frame_arena.h"

#include <algorithm>

namespace claque::animcache
{

FrameArena::~FrameArena()
{
    for (const Chunk &chunk : chunks_) memory_->deallocate(chunk.memory, chunk.bytes, alignment);
}

void FrameArena::reset()
{
    chunk_ = offset_ = 0;
    used_bytes_ = 0;
}

// Chunks grow with the memory held, so that they are few; an arena is at most a third larger than its fullest update.
void FrameArena::add_chunk(size_t bytes)
{
    constexpr uint64_t min_bytes = 1 << 16;
    if (chunks_.size() == chunks_.capacity()) chunks_.reserve(2 * chunks_.size() + 8);
    Chunk chunk;
    chunk.bytes = static_cast<size_t>(std::max({uint64_t(bytes), reserved_bytes_ / 3, min_bytes}));
    chunk.bytes = (chunk.bytes + alignment - 1) / alignment * alignment;
    chunk.memory = static_cast<std::byte *>(memory_->allocate(chunk.bytes, alignment));
    chunks_.push_back(chunk);
    reserved_bytes_ += chunk.bytes;
}

float *FrameArena::take(size_t bytes) noexcept
{
    if (bytes > SIZE_MAX - alignment) return nullptr;
    const size_t rounded = (bytes + alignment - 1) / alignment * alignment;
    while (chunk_ < chunks_.size() && chunks_[chunk_].bytes - offset_ < rounded) ++chunk_, offset_ = 0;
    if (chunk_ == chunks_.size()) {
        try {
            add_chunk(rounded);
        } catch (...) {
            return nullptr;
        }
    }
    float *block = reinterpret_cast<float *>(chunks_[chunk_].memory + offset_);
    offset_ += rounded;
    used_bytes_ += rounded;
    return block;
}

}  // namespace claque::animcache
