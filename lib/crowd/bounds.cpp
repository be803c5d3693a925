// A coarse bound of where an actor can be, for the first test of a large crowd (lib/frame/bounds.cpp).
#include <cmath>

#include <glm/common.hpp>

#include "lib/crowd/rows.h"

namespace claque::crowd
{

namespace
{

// Holds where the pieces of its track have the actor at any time.
track::Box reach_of(const Follow &follow) noexcept
{
    track::Box box = follow.track->reach;
    for (const track::Track *piece : follow.earlier) {
        if (!piece) break;
        box.low = glm::min(box.low, piece->reach.low), box.high = glm::max(box.high, piece->reach.high);
    }
    return box;
}

}  // namespace

void bound(Crowd &crowd, uint32_t row) noexcept
{
    math::RoughSphere &out = crowd.tables.actors.bounds[row];
    out = math::RoughSphere();
    if (!crowd.alive(row) || crowd.group_of(row) != model::none) return;
    const Extent &extent = crowd.extent_of(row);
    const Transform &transform = crowd.transform_of(row);
    const double own = std::fabs(double(transform.scale)) * double(extent.refpoint) + double(extent.slack);
    const Follow *follow = crowd.follows().of(row);
    if (!follow) {
        out = math::rough_sphere_of(transform.position, own);
        return;
    }
    const track::Box box = reach_of(*follow);
    const glm::dvec3 half = 0.5 * (box.high - box.low);
    out = math::rough_sphere_of(box.low + half, std::sqrt(half.x * half.x + half.y * half.y + half.z * half.z) + own);
}

}  // namespace claque::crowd
