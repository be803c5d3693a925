#include "lib/crowd/transform.h"

#include <cmath>

#include "lib/base/error.h"
#include "lib/math/eye_transform.h"

namespace claque::crowd
{

using base::fail;

namespace
{

// Normalised: products of many unit quaternions drift.
glm::quat unit(const glm::dquat &q)
{
    const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return glm::quat(static_cast<float>(q.w / length), static_cast<float>(q.x / length),
                     static_cast<float>(q.y / length), static_cast<float>(q.z / length));
}

glm::dquat wide(const glm::quat &q) { return glm::dquat(q.w, q.x, q.y, q.z); }

}  // namespace

Transform checked(const Transform &transform)
{
    const glm::quat &q = transform.orientation;
    const double length = std::sqrt(double(q.w) * q.w + double(q.x) * q.x + double(q.y) * q.y + double(q.z) * q.z);
    for (int k = 0; k < 3; ++k)
        if (!std::isfinite(transform.position[k])) fail(CLQ_ARGUMENT, "coordinate %d of a position is not finite", k);
    if (!(std::fabs(length - 1) <= 1e-3)) fail(CLQ_ARGUMENT, "an orientation has length %g instead of 1", length);
    if (!std::isfinite(transform.scale) || transform.scale == 0)
        fail(CLQ_ARGUMENT, "a scale is %g: it must be finite and not 0", double(transform.scale));
    return transform;
}

glm::dvec3 composed_position(const Transform &outer, const glm::dvec3 &inner)
{
    return outer.position + math::rotation_of(outer.orientation) * (inner * static_cast<double>(outer.scale));
}

Transform composed(const Transform &outer, const Transform &inner)
{
    Transform out;
    out.position = composed_position(outer, inner.position);
    out.orientation = unit(wide(outer.orientation) * wide(inner.orientation));
    out.scale = outer.scale * inner.scale;
    return out;
}

Transform relative(const Transform &outer, const Transform &world)
{
    Transform out;
    // The transpose is the inverse rotation.
    out.position = (world.position - outer.position) * math::rotation_of(outer.orientation) *
                   (1 / static_cast<double>(outer.scale));
    out.orientation = unit(glm::conjugate(wide(outer.orientation)) * wide(world.orientation));
    out.scale = world.scale / outer.scale;
    return out;
}

}  // namespace claque::crowd
