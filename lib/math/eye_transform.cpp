#include "lib/math/eye_transform.h"

namespace claque::math
{

glm::dmat3 rotation_of(const glm::quat &q)
{
    const double w = q.w, x = q.x, y = q.y, z = q.z;
    const double square = w * w + x * x + y * y + z * z;
    const double s = square > 0 ? 2 / square : 0;
    return glm::dmat3(1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y),  //
                      s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x),  //
                      s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y));
}

EyeTransform eye_transform(const glm::dmat3 &world_to_eye, const glm::dvec3 &eye, const glm::dvec3 &position,
                           const glm::quat &orientation, double scale)
{
    EyeTransform out;
    out.axes = world_to_eye * rotation_of(orientation) * scale;
    out.origin = world_to_eye * (position - eye);
    return out;
}

void store_matrix(const EyeTransform &place, float out[16])
{
    for (int k = 0; k < 3; ++k) {
        for (int r = 0; r < 3; ++r) out[4 * k + r] = static_cast<float>(place.axes[k][r]);
        out[4 * k + 3] = 0;
        out[12 + k] = static_cast<float>(place.origin[k]);
    }
    out[15] = 1;
}

}  // namespace claque::math
