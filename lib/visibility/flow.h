// Optical flow: where the points that pixels show are in the picture of another time.
#pragma once

#include "lib/frame/posed_at.h"
#include "lib/visibility/picture.h"

namespace claque::visibility
{

// One individual at the other time.
struct Moved {
    bool there = false;  // false: it is not in the world then, or no pixel shows it
    glm::dmat3 axes;     // from its own space to the other camera's eye space
    glm::dvec3 origin;
    const float *positions = nullptr;  // 3 a source vertex
};

// out: [2 * pixels] pixels to the right and up; NaN where no individual is, where it is not there at the other time,
// and where the point is then behind the eye.
void write_flow(const Picture &picture, base::Span<const Moved> moved, const float *projection, const base::Jobs &jobs,
                float *out);

}  // namespace claque::visibility
