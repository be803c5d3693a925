// What the split of one model may cost. A few kilobytes of a file can ask for hours of motion of hundreds of nodes, so
// memory and the number of evaluated poses are bounded by a multiple of what was read. What needs more is refused with
// numbers, or made from less: clips keep their channels, spheres follow from lengths.
#pragma once

#include "lib/model/model.h"
#include "lib/model/template.h"

namespace claque::meshsplit
{

class Allowance
{
public:
    // Loading and splitting together may hold so many bytes for each byte that was read, and this much for any model.
    static constexpr uint64_t multiple = 64, always_bytes = 16ull << 20;
    // Local transforms that may be evaluated: for any model, and for each byte that was read.
    static constexpr uint64_t always_transforms = 1ull << 26, transforms_per_byte = 16;

    // The model itself is taken from the allowance.
    explicit Allowance(const model::Model &model);

    // Throws base::Error (LIMIT) that names `what` and both numbers unless so much is left.
    void take(uint64_t bytes, const char *what);
    void take_transforms(uint64_t count, const char *what);

    uint64_t source_bytes() const { return source_; }
    // What is left of the bytes, and what one search of poses may evaluate.
    uint64_t bytes() const { return bytes_ - taken_; }
    uint64_t transforms() const { return transforms_; }
    // Texels of a texture that may be looked at for the zones of all triangles.
    uint64_t texels() const { return 16 * transforms_; }

private:
    uint64_t source_ = 0, bytes_ = 0, taken_ = 0, transforms_ = 0;
};

// What the search for the most distant poses (reach.h, spheres.h) may cost. Where it would be more, spheres follow from
// the lengths of the nodes' motions (blend_reach.h): larger, and at the cost of reading every key once.
struct SearchLimits {
    bool search = true;
    uint64_t poses = ~0ull;     // that a walk may visit
    uint64_t vertices = ~0ull;  // that may be skinned
    uint64_t precise = ~0ull;   // poses that may be bounded by support functions
};
SearchLimits search_limits(const model::Template &tmpl, const Allowance &allowance);

}  // namespace claque::meshsplit
