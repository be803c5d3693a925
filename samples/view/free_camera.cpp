#include "samples/view/free_camera.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/check.h"
#include "samples/scenes/eye.h"

namespace view
{
namespace
{

constexpr double steepest_rad = 1.53, nearest_m = 0.05, farthest_m = 1e5;
constexpr double radians_per_height = 4;

double within(double value, double low, double high)
{
    return std::isfinite(value) ? std::clamp(value, low, high) : low;
}

}  // namespace

Point FreeCamera::direction() const
{
    return {std::sin(yaw_rad) * std::cos(pitch_rad), std::sin(pitch_rad), -std::cos(yaw_rad) * std::cos(pitch_rad)};
}

Point FreeCamera::eye() const
{
    const Point d = direction();
    return {target[0] - d[0] * distance_m, target[1] - d[1] * distance_m, target[2] - d[2] * distance_m};
}

clq_camera FreeCamera::camera(double aspect) const
{
    clq_look_at_def def = clq_look_at_def_init();
    const Point from = eye();
    std::copy(from.begin(), from.end(), def.eye);
    std::copy(target.begin(), target.end(), def.target);
    def.fov_y_rad = static_cast<float>(fov_rad);
    def.aspect = static_cast<float>(aspect);
    def.z_near = static_cast<float>(within(distance_m * 0.02, 0.02, 2));
    def.z_far = static_cast<float>(std::max(far_m, 3 * distance_m));
    clq_camera camera = {};
    scenes::check(clq_camera_look_at(&def, &camera));
    return camera;
}

void FreeCamera::orbit(double right, double down)
{
    yaw_rad = std::remainder(yaw_rad + right * radians_per_height, 2 * 3.141592653589793);
    pitch_rad = within(pitch_rad - down * radians_per_height, -steepest_rad, steepest_rad);
}

void FreeCamera::pan(double right, double down)
{
    // What is under the mouse stays there, at the target's depth.
    const double metres = 2 * distance_m * std::tan(fov_rad / 2);
    const Point side = {std::cos(yaw_rad), 0, std::sin(yaw_rad)};
    const Point up = {-std::sin(yaw_rad) * std::sin(pitch_rad), std::cos(pitch_rad),
                      std::cos(yaw_rad) * std::sin(pitch_rad)};
    for (size_t k = 0; k < 3; ++k) target[k] = within(target[k] + metres * (down * up[k] - right * side[k]), -1e7, 1e7);
}

void FreeCamera::zoom(double notches)
{
    distance_m = within(distance_m * std::pow(0.85, notches), nearest_m, farthest_m);
}

void FreeCamera::walk(double right_m, double ahead_m)
{
    const double s = std::sin(yaw_rad), c = std::cos(yaw_rad);
    target[0] = within(target[0] + right_m * c + ahead_m * s, -1e7, 1e7);
    target[2] = within(target[2] + right_m * s - ahead_m * c, -1e7, 1e7);
}

void FreeCamera::frame(const Point &centre, double radius_m)
{
    target = centre;
    distance_m = within(radius_m / std::sin(fov_rad / 2) * 1.15, nearest_m, farthest_m);
}

FreeCamera free_camera_from(const clq_camera &camera, double depth_m)
{
    const scenes::Eye eye = scenes::eye_of(camera);
    // The third row of the rotation, reversed, is the direction of view.
    const double d[3] = {-static_cast<double>(eye.rotation[2]), -static_cast<double>(eye.rotation[6]),
                         -static_cast<double>(eye.rotation[10])};
    FreeCamera made;
    made.pitch_rad = std::asin(std::clamp(d[1], -1.0, 1.0));
    made.pitch_rad = std::clamp(made.pitch_rad, -steepest_rad, steepest_rad);
    made.yaw_rad = std::atan2(d[0], -d[2]);
    made.distance_m = std::clamp(depth_m, nearest_m, farthest_m);
    made.fov_rad = 2 * std::atan(1 / static_cast<double>(camera.projection[5]));
    const double a = static_cast<double>(camera.projection[10]), b = static_cast<double>(camera.projection[14]);
    if (a + 1 < 0) made.far_m = b / (a + 1);
    const Point ahead = made.direction();
    for (size_t k = 0; k < 3; ++k) made.target[k] = camera.eye[k] + ahead[k] * made.distance_m;
    return made;
}

double depth_of_ground(const clq_camera &camera, double otherwise)
{
    const scenes::Eye eye = scenes::eye_of(camera);
    const double down = static_cast<double>(eye.rotation[6]);  // of the direction of view
    const double depth = down > 1e-3 ? (camera.eye[1] - 1) / down : otherwise;
    return depth > 0.5 && depth < 20 * otherwise ? depth : otherwise;
}

bool project(const clq_camera &camera, const Point &at, double &x, double &y)
{
    const scenes::Eye eye = scenes::eye_of(camera);
    double relative[3], seen[3], clip[4];
    for (size_t k = 0; k < 3; ++k) relative[k] = at[k] - camera.eye[k];
    for (size_t row = 0; row < 3; ++row) {
        seen[row] = 0;
        for (size_t k = 0; k < 3; ++k) seen[row] += static_cast<double>(eye.rotation[4 * k + row]) * relative[k];
    }
    for (size_t row = 0; row < 4; ++row) {
        clip[row] = static_cast<double>(camera.projection[12 + row]);
        for (size_t k = 0; k < 3; ++k) clip[row] += static_cast<double>(camera.projection[4 * k + row]) * seen[k];
    }
    if (!(clip[3] > 1e-6)) return false;
    x = clip[0] / clip[3];
    y = clip[1] / clip[3];
    return true;
}

}  // namespace view
