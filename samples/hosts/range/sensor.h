// Range sensors: the rays of a spinning lidar, and of a depth camera.
#pragma once

#include "samples/hosts/range/ray_scene.h"

namespace range
{

// A lidar turns about the upward axis, once a scan.
struct Lidar {
    int rings = 32, steps = 1024;  // a turn
    double lowest_deg = -25, highest_deg = 15;
    float max_distance = 60;
};

// Ring by ring from the lowest, step by step from +x towards -z.
std::vector<Ray> rays_of(const Lidar &lidar);

// Four cameras round a sensor, which see all of its rays with room to spare.
std::vector<clq_camera> cameras_round(const std::array<double, 3> &eye, const Lidar &lidar);

// One ray for each pixel of a camera, rows from the bottom up, along the centres of the pixels.
std::vector<Ray> rays_of(const clq_camera &camera, int width, int height, float max_distance);

}  // namespace range
