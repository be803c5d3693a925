// The rows of a crowd, by group: what is tested together lies together, so that a group that is not seen costs one test
// and its members nothing (S0 4.3).
#pragma once

#include "lib/crowd/crowd.h"

namespace claque::frame
{

// First those without a group, then group after group; rows ascend inside each.
struct Block {
    uint32_t group = model::none;   // row of the group
    uint32_t first = 0, count = 0;  // of Blocks::rows
    uint64_t version = 0;           // of the group when its sphere was found
    model::Sphere sphere;           // Group Bsphere, in the group's space
};

class Blocks
{
public:
    explicit Blocks(std::pmr::memory_resource *memory) : rows_(memory), blocks_(memory), at_(memory) {}

    // Brings order and spheres up to date. May throw std::bad_alloc and then is as it was, or empty.
    void follow(const crowd::Crowd &crowd);

    base::Span<const Block> blocks() const { return base::Span<const Block>(blocks_); }
    uint32_t row(uint32_t i) const { return rows_[i]; }

private:
    void arrange(const crowd::Crowd &crowd);

    uint64_t structure_ = 0;  // of the crowd when it was arranged
    std::pmr::vector<uint32_t> rows_;
    std::pmr::vector<Block> blocks_;
    std::pmr::vector<uint32_t> at_;  // scratch: where each group's next row goes
};

// Holds the Refpoint Bspheres of the rows, however they are turned, in the space that their places are given in.
model::Sphere sphere_of(const crowd::Crowd &crowd, const uint32_t *rows, uint32_t count);

}  // namespace claque::frame
