// The visibility of a character's surface. Skin under clothes and the inside of a mouth are hidden, and what a level
// does there does not show. Internal to lib/lod.
#pragma once

#include "lib/base/services.h"
#include "lib/lod/surface/surface_samples.h"

namespace claque::lod
{

// Returns, for [triangles of `parts`] at rest, the fraction of all directions from which a distant eye sees the
// triangle past all others: about a half for open surface, 0 for hidden surface. The back counts only if the material
// is double-sided. What has holes hides nothing. A triangle visible from only one of the fourteen directions counts as
// hidden, for example legs seen from below under a skirt. All are 1 if nothing is visible. The result does not depend
// on `jobs`. Deterministic.
std::vector<double> visibility_of(const model::Model &model, const PosedParts &parts, const base::Jobs &jobs = {});

// The same for triangles outside of parts, at four samples each (full) or at their centres only (fast).
struct VisibilityQuery {
    std::array<glm::dvec3, 3> corners;
    bool two_sided = false;  // the back is visible as well
    bool has_holes = false;  // what lies behind it is visible
};
enum class VisibilityQuality : uint8_t { fast, full };
std::vector<double> visibility_of(const std::vector<VisibilityQuery> &queries,
                                  VisibilityQuality quality = VisibilityQuality::full, const base::Jobs &jobs = {});
bool is_two_sided(const model::Model &model, const model::Part &part);

// Returns the triangles' areas times their visibility.
std::vector<double> visible_areas(const model::Model &model, const PosedParts &parts);

}  // namespace claque::lod
