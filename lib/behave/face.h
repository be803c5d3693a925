// Shapes laid over a face with weights: expressions and mouths blend from some to others.
#pragma once

#include "lib/behave/writer.h"

namespace claque::behave
{

// Weights sum to at most 1; what is missing is the face as others leave it.
struct Face {
    struct Entry {
        uint32_t pose = model::none;
        double weight = 0;
    };
    Entry entries[10];
    uint32_t count = 0;

    static Face of(uint32_t pose);  // none: nothing
    // Goes over to another by the share `by` in [0, 1].
    void blend(const Face &other, double by);
};

// Writes each degree of freedom that a shape names once.
void apply_face(const Face &face, base::Span<const crowd::DofPose> poses, base::Span<const crowd::DofValue> values,
                Writer &writer) noexcept;

}  // namespace claque::behave
