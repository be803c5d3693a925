// The rows of a crowd, sorted by group: rows that are tested together are contiguous, so that a group out of sight
// costs one test and its members nothing (S0 4.3).
#pragma once

#include "lib/base/held_bytes.h"
#include "lib/crowd/crowd.h"

namespace claque::frame
{

// The actors without a group come first, then group after group; rows ascend in each.
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

    // Updates order and spheres. May throw std::bad_alloc; the blocks are unchanged or empty then.
    void follow(const crowd::Crowd &crowd);

    base::Span<const Block> blocks() const { return base::Span<const Block>(blocks_); }
    uint32_t row(uint32_t i) const { return rows_[i]; }
    uint64_t bytes() const { return base::held_bytes(rows_, blocks_, at_); }

private:
    void arrange(const crowd::Crowd &crowd);

    uint64_t structure_ = 0;  // the crowd's structure version at the last arrangement
    std::pmr::vector<uint32_t> rows_;
    std::pmr::vector<Block> blocks_;
    std::pmr::vector<uint32_t> at_;  // scratch: index of each group's next row
};

// A sphere that holds the Refpoint Bspheres of the rows in any orientation, in the space of their transforms.
model::Sphere sphere_of(const crowd::Crowd &crowd, const uint32_t *rows, uint32_t count);

}  // namespace claque::frame
