#include "samples/hosts/range/sensor.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/check.h"

namespace range
{

std::vector<Ray> rays_of(const Lidar &lidar)
{
    constexpr double turn = 6.283185307179586, degree = turn / 360;
    std::vector<Ray> out;
    for (int ring = 0; ring < lidar.rings; ++ring) {
        const double share = lidar.rings > 1 ? static_cast<double>(ring) / (lidar.rings - 1) : 0;
        const double up = degree * (lidar.lowest_deg + share * (lidar.highest_deg - lidar.lowest_deg));
        for (int step = 0; step < lidar.steps; ++step) {
            const double round = turn * step / lidar.steps;
            out.push_back({{static_cast<float>(std::cos(up) * std::cos(round)), static_cast<float>(std::sin(up)),
                            static_cast<float>(-std::cos(up) * std::sin(round))},
                           lidar.max_distance});
        }
    }
    return out;
}

std::vector<clq_camera> cameras_round(const std::array<double, 3> &eye, const Lidar &lidar)
{
    // Towards the corners of a square picture a ring of the lidar rises: the tangent grows by the root of two.
    const double steepest =
        std::max(std::fabs(lidar.lowest_deg), std::fabs(lidar.highest_deg)) * 6.283185307179586 / 360;
    const double half = std::max(1.0, 1.4143 * std::tan(steepest)) * 1.02;
    std::vector<clq_camera> out;
    for (int k = 0; k < 4; ++k) {
        clq_look_at_def look = clq_look_at_def_init();
        for (size_t i = 0; i < 3; ++i) look.eye[i] = look.target[i] = eye[i];
        look.target[0] += k == 0 ? 1 : k == 2 ? -1 : 0;
        look.target[2] += k == 1 ? -1 : k == 3 ? 1 : 0;
        look.fov_y_rad = static_cast<float>(2 * std::atan(half));
        look.aspect = static_cast<float>(1.02 / half);
        look.z_near = 0.05f, look.z_far = lidar.max_distance * 1.5f;
        scenes::check(clq_camera_look_at(&look, &out.emplace_back()));
    }
    return out;
}

std::vector<Ray> rays_of(const clq_camera &camera, int width, int height, float max_distance)
{
    std::vector<Ray> out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            clq_ray ray = {};
            scenes::check(clq_camera_get_ray(&camera, static_cast<float>(2 * (x + 0.5) / width - 1),
                                             static_cast<float>(2 * (y + 0.5) / height - 1), &ray));
            out.push_back({{static_cast<float>(ray.direction[0]), static_cast<float>(ray.direction[1]),
                            static_cast<float>(ray.direction[2])},
                           max_distance});
        }
    return out;
}

}  // namespace range
