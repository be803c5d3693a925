#include "samples/labels/projection.h"

namespace labels
{

std::array<double, 3> to_eye(const clq_camera &camera, const std::array<double, 3> &world)
{
    const double v[3] = {world[0] - camera.eye[0], world[1] - camera.eye[1], world[2] - camera.eye[2]};
    const float *q = camera.rotation_xyzw;
    const double a = static_cast<double>(q[0]), b = static_cast<double>(q[1]), c = static_cast<double>(q[2]),
                 w = static_cast<double>(q[3]);
    const double t[3] = {2 * (b * v[2] - c * v[1]), 2 * (c * v[0] - a * v[2]), 2 * (a * v[1] - b * v[0])};
    return {v[0] + w * t[0] + b * t[2] - c * t[1], v[1] + w * t[1] + c * t[0] - a * t[2],
            v[2] + w * t[2] + a * t[1] - b * t[0]};
}

std::array<double, 3> from_eye(const clq_camera &camera, const std::array<double, 3> &eye)
{
    clq_camera back = camera;
    for (int k = 0; k < 3; ++k) back.eye[k] = 0, back.rotation_xyzw[k] = -camera.rotation_xyzw[k];
    std::array<double, 3> out = to_eye(back, eye);
    for (size_t k = 0; k < 3; ++k) out[k] += camera.eye[k];
    return out;
}

bool project_eye(const Sample &sample, const std::array<double, 3> &eye, std::array<double, 2> &px)
{
    const float *p = sample.camera.projection;
    const auto row = [&](size_t k) {
        return static_cast<double>(p[k]) * eye[0] + static_cast<double>(p[4 + k]) * eye[1] +
               static_cast<double>(p[8 + k]) * eye[2] + static_cast<double>(p[12 + k]);
    };
    const double w = row(3);
    if (!(w > 0)) return false;
    px = {(row(0) / w + 1) / 2 * sample.width, (1 - row(1) / w) / 2 * sample.height};
    return true;
}

bool project(const Sample &sample, const std::array<double, 3> &world, std::array<double, 2> &px, double &depth_m)
{
    const std::array<double, 3> eye = to_eye(sample.camera, world);
    depth_m = -eye[2];
    return project_eye(sample, eye, px);
}

}  // namespace labels
