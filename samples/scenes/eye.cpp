#include "samples/scenes/eye.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "samples/scenes/check.h"

namespace scenes
{

Eye eye_of(const clq_camera &camera)
{
    Eye eye = {};
    std::memcpy(eye.position, camera.eye, sizeof eye.position);
    std::memcpy(eye.projection, camera.projection, sizeof eye.projection);
    double q[4];
    double norm = 0;
    for (int i = 0; i < 4; ++i) norm += static_cast<double>(camera.rotation_xyzw[i]) * camera.rotation_xyzw[i];
    for (int i = 0; i < 4; ++i) q[i] = camera.rotation_xyzw[i] / std::sqrt(norm);
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double m[9] = {1 - 2 * (y * y + z * z), 2 * (x * y + z * w),     2 * (x * z - y * w),
                         2 * (x * y - z * w),     1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
                         2 * (x * z + y * w),     2 * (y * z - x * w),     1 - 2 * (x * x + y * y)};
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) eye.rotation[4 * column + row] = static_cast<float>(m[3 * column + row]);
    eye.rotation[15] = 1;
    std::memcpy(eye.view, eye.rotation, sizeof eye.view);
    for (int row = 0; row < 3; ++row)
        eye.view[12 + row] =
            static_cast<float>(-(m[row] * camera.eye[0] + m[3 + row] * camera.eye[1] + m[6 + row] * camera.eye[2]));
    return eye;
}

clq_camera look(const double (&eye)[3], const double (&target)[3], double fov_y_deg, double aspect, double z_near,
                double z_far)
{
    clq_camera camera = {};
    clq_look_at_def def = clq_look_at_def_init();
    std::copy_n(eye, 3, def.eye);
    std::copy_n(target, 3, def.target);
    def.fov_y_rad = static_cast<float>(fov_y_deg * 3.141592653589793 / 180.0);
    def.aspect = static_cast<float>(aspect);
    def.z_near = static_cast<float>(z_near), def.z_far = static_cast<float>(z_far);
    check(clq_camera_look_at(&def, &camera));
    return camera;
}

}  // namespace scenes
