#include "lib/pose/blend.h"

#include "lib/math/slerp.h"

namespace claque::pose
{

glm::quat nlerp(const glm::quat &a, const glm::quat &b, float weight)
{
    const double cosine = double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z + double(a.w) * b.w;
    const double p = 1 - double(weight), q = cosine < 0 ? -double(weight) : double(weight);
    return math::unit_quat(p * a.w + q * b.w, p * a.x + q * b.x, p * a.y + q * b.y, p * a.z + q * b.z);
}

glm::quat add_rotation(const glm::quat &below, const glm::quat &from, const glm::quat &to, float weight)
{
    const glm::quat turn = glm::conjugate(from) * to;
    return below * nlerp(glm::quat(1, 0, 0, 0), turn, weight);
}

}  // namespace claque::pose
