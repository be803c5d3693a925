// Scenery under construction in parts. Each has a fine form for the eye near by, and may have a coarse one.
#pragma once

#include "samples/scenes/geometry.h"

namespace scenes
{

class Parts
{
public:
    explicit Parts(float texture_metres = 1.0f) : fine(texture_metres), coarse(texture_metres) {}

    Geometry fine, coarse;

    // The part that is open ends here. One without a coarse form has the fine one at all distances.
    void end();

    struct Span {
        uint32_t first, count;  // indices
    };
    struct Part {
        Span fine, coarse;
    };
    const std::vector<Part> &all() const { return parts_; }

private:
    std::vector<Part> parts_;
    uint32_t fine_done_ = 0, coarse_done_ = 0;
};

}  // namespace scenes
