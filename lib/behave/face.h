// Weighted poses of a face: expressions and mouths blend between them.
#pragma once

#include "lib/behave/writer.h"

namespace claque::behave
{

// Weights sum to at most 1; the rest keeps what other mechanisms wrote.
struct Face {
    struct Entry {
        uint32_t pose = model::none;
        double weight = 0;
    };
    Entry entries[10];
    uint32_t count = 0;

    static Face of(uint32_t pose);  // none: empty
    // Blends towards another face with the weight `by` in [0, 1].
    void blend(const Face &other, double by);
};

// Writes each degree of freedom that occurs in the poses once.
void apply_face(const Face &face, base::Span<const crowd::DofPose> poses, base::Span<const crowd::DofValue> values,
                Writer &writer) noexcept;

}  // namespace claque::behave
