// The triangle of a number: its individual, its part and its zone.
#pragma once

#include <vector>

#include "lib/draw/triangle_numbers.h"

namespace claque::visibility
{

struct Found {
    uint32_t item = model::none;  // of the draw list
    uint32_t triangle = 0;        // of its level
    uint32_t part = 0;            // of its level
    uint32_t zone = model::none;  // of all its pixels; none: a dirty triangle, or one with holes
    uint32_t texture = 0;
    const uint32_t *corners = nullptr;  // three source vertices
};

class Numbers
{
public:
    Numbers(const draw::DrawList &list, std::pmr::memory_resource *memory);  // throws std::bad_alloc

    uint64_t count() const { return firsts_.back(); }
    // `number`: from 0, less than count().
    Found find(uint64_t number) const;

private:
    const draw::DrawList &list_;
    std::pmr::vector<uint64_t> firsts_;  // by item, and the end
};

}  // namespace claque::visibility
