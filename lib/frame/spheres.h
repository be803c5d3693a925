// Internal Bspheres (S0 4.1): what the parts of one individual occupy in its present pose, leaf to root.
#pragma once

#include "lib/math/frustum.h"
#include "lib/model/template.h"

namespace claque::frame
{

// Which parts of a level a frustum may show.
struct PartsInView {
    uint64_t parts = 0;   // bit k: part k
    uint32_t built = 0;   // spheres
    uint32_t tested = 0;  // against the frustum
};

// From model space to where the frustum is: axes hold rotation and one factor.
struct ToFrustum {
    glm::dmat3 axes;
    glm::dvec3 origin;
    double scale;  // positive
};

// Top down: what lies wholly inside or outside settles all below it. `no` for a part is certain.
//   palette   of the pose, every entry that the level's parts name
PartsInView parts_in_view(const model::Template &tmpl, const model::Level &level, const math::Affine *palette,
                          const ToFrustum &to, const math::Frustum &frustum);

}  // namespace claque::frame
