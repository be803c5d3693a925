#include "tests/actors/aim.h"

#include <cmath>

#include "lib/math/eye_transform.h"
#include "tests/actors/robot.h"

namespace actors
{

namespace
{

glm::dvec3 crossed(const glm::dvec3 &a, const glm::dvec3 &b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
glm::dvec3 unit(const glm::dvec3 &a) { return a / std::sqrt(along(a, a)); }

constexpr float fov_y = 0.9f, aspect = 1.25f, z_near = 1,
                z_far = 40;  // so that the far plane is exact within 0.1 mm in floats

}  // namespace

glm::dvec3 random_direction(uint32_t k)
{
    const double height = 2 * random_unit(40, k) - 1, turn = 6.283185307 * random_unit(41, k);
    const double flat = std::sqrt(1 - height * height);
    return {flat * std::cos(turn), height, flat * std::sin(turn)};
}

claque::frame::Camera aimed(uint32_t k, const glm::dvec3 &corner, const glm::dvec3 &out, double inside)
{
    // The plane looks along `out`: inwards lies what is farther out.
    const glm::dvec3 across = unit(crossed(out, random_direction(k + 5000))), beside = crossed(out, across);
    const uint32_t plane = k % 6;
    const bool upright = plane == 2 || plane == 3;
    const double half_tangent = std::tan(double(fov_y) / 2) * (upright ? 1.0 : double(aspect));
    const double angle = std::atan(half_tangent), turn = plane % 2 ? -1 : 1;
    glm::dvec3 forward, up, eye;
    if (plane < 4) {
        // left, right, bottom, top: the ray `along_plane` lies in the plane, in the middle of its edge.
        const glm::dvec3 along_plane = beside * turn;
        forward = out * std::sin(angle) + along_plane * std::cos(angle);
        const glm::dvec3 inwards = out * std::cos(angle) - along_plane * std::sin(angle);
        up = upright ? inwards * turn : across;
        eye = corner - along_plane * (2 + 25 * random_unit(42, k)) - out * inside;
    } else {
        forward = plane == 4 ? out : out * -1.0;
        up = across;
        eye = plane == 4 ? corner - out * (double(z_near) + inside) : corner + out * (double(z_far) - inside);
    }
    return claque::frame::look_at(eye, eye + forward * 10.0, glm::vec3(up), fov_y, aspect, z_near, z_far);
}

Camera::Camera(const claque::frame::Camera &camera) : eye_(camera.eye)
{
    const glm::dmat3 turn = claque::math::rotation_of(camera.rotation);
    for (int r = 0; r < 4; ++r) {
        rows_[r] = glm::dvec3(0);
        for (int c = 0; c < 3; ++c)
            for (int k = 0; k < 3; ++k) rows_[r][k] += double(camera.projection[4 * c + r]) * turn[k][c];
        constants_[r] = double(camera.projection[12 + r]);
    }
}

bool Camera::sees(const glm::dvec3 &point) const
{
    const glm::dvec3 away = point - eye_;
    double clip[4];
    for (int r = 0; r < 4; ++r) clip[r] = along(rows_[r], away) + constants_[r];
    // A vertex on a plane, but for rounding, is no vertex that must be seen.
    const double w = clip[3] - 1e-8 * std::fabs(clip[3]);
    return std::fabs(clip[0]) <= w && std::fabs(clip[1]) <= w && std::fabs(clip[2]) <= w;
}

}  // namespace actors
