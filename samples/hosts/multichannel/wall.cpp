#include "samples/hosts/multichannel/wall.h"

#include <algorithm>

#include "samples/scenes/eye.h"

namespace multichannel
{

Wall::Wall(double tan_half_width, double tan_half_height, double z_near, double z_far)
    : tan_half_width_(tan_half_width), tan_half_height_(tan_half_height), near_(z_near), far_(z_far)
{
}

clq_camera Wall::camera(const double (&eye)[3], const double (&target)[3], int first, int count) const
{
    clq_camera camera = scenes::look(eye, target, 60, 1, near_, far_);
    // glFrustum(left, right, -tan_half_height, tan_half_height) at distance 1; it replaces the projection of look().
    const double step = 2 * tan_half_width_ / columns;
    const double left = -tan_half_width_ + step * first, right = left + step * count;
    std::fill(camera.projection, camera.projection + 16, 0.0f);
    camera.projection[0] = static_cast<float>(2 / (right - left));
    camera.projection[5] = static_cast<float>(1 / tan_half_height_);
    camera.projection[8] = static_cast<float>((right + left) / (right - left));
    camera.projection[10] = static_cast<float>((near_ + far_) / (near_ - far_));
    camera.projection[11] = -1;
    camera.projection[14] = static_cast<float>(2 * near_ * far_ / (near_ - far_));
    return camera;
}

}  // namespace multichannel
