// Internal Bspheres (S0 4.1): bounding spheres of an individual's parts in its present pose, combined from leaf to
// root.
#pragma once

#include "lib/math/frustum.h"
#include "lib/model/template.h"

namespace claque::frame
{

// Which parts of a level may be visible in a frustum.
struct PartsInView {
    uint64_t parts = 0;   // bit k: part k
    uint32_t built = 0;   // spheres
    uint32_t tested = 0;  // against the frustum
};

// From model space to the space of the frustum: axes hold the rotation and one scale.
struct ToFrustum {
    glm::dmat3 axes;
    glm::dvec3 origin;
    double scale;  // positive
};

// Tests top down: a sphere wholly inside or outside decides for everything below it. A part that is not reported is
// certainly invisible.
//   palette   of the pose, every entry that the level's parts name
PartsInView parts_in_view(const model::Template &tmpl, const model::Level &level, const math::Affine *palette,
                          const ToFrustum &to, const math::Frustum &frustum);

}  // namespace claque::frame
