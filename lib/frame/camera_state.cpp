#include "lib/frame/camera_state.h"

#include <algorithm>
#include <cmath>

#include "lib/math/eye_transform.h"

namespace claque::frame
{

namespace
{

// The distances of levels of detail are given for a reference picture of 768 lines over 60 degrees: half its height
// divided by the tangent of half the angle.
constexpr double home_px = 384 * 1.7320508075688772;

math::Frustum pyramid_of(const View &view)
{
    const double scale = double(view.cull_scale);
    const auto bound = [&](int i) { return std::clamp(2 * double(view.tile[i]) - 1, -scale, scale); };
    return math::frustum_of(view.camera.projection, {bound(0), bound(2), bound(1), bound(3)});
}

}  // namespace

CameraState::CameraState(const View &view)
    : eye(view.camera.eye),
      world_to_eye(math::rotation_of(view.camera.rotation)),
      frustum(math::rotated_back(pyramid_of(view), world_to_eye)),
      shadow(view.shadow),
      rough(frustum, eye, shadow),
      distance_scale(1),
      min_distance(0)
{
    const float *p = view.camera.projection;
    // pixels per unit at a distance of one unit
    const double pixels = std::fabs(double(p[5])) * 0.5 * double(view.height_px);
    if (!(pixels > 0)) return;
    if (p[11] != 0) distance_scale = home_px / pixels;
    else min_distance = home_px / pixels, distance_scale = 0;
}

}  // namespace claque::frame
