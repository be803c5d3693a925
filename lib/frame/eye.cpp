#include "lib/frame/eye.h"

#include <cmath>

#include "lib/math/place.h"

namespace claque::frame
{

namespace
{

// Distances that a host gives to levels of detail hold in a picture of 768 lines over 60 degrees: half its height over
// the tangent of half the angle.
constexpr double home_px = 384 * 1.7320508075688772;

math::Frustum pyramid_of(const View &view)
{
    float narrowed[16];
    for (int i = 0; i < 16; ++i) narrowed[i] = view.camera.projection[i] / (i % 4 < 2 ? view.cull_scale : 1.0f);
    return math::frustum_of(narrowed);
}

}  // namespace

EyeOf::EyeOf(const View &view)
    : eye(view.camera.eye),
      world_to_eye(math::rotation_of(view.camera.rotation)),
      frustum(math::turned_back(pyramid_of(view), world_to_eye)),
      shadow(view.shadow),
      detail(1),
      least(0)
{
    const float *p = view.camera.projection;
    const double pixels = std::fabs(double(p[5])) * 0.5 * double(view.height_px);  // of a unit across, a unit away
    if (!(pixels > 0)) return;
    if (p[11] != 0) detail = home_px / pixels;
    else least = home_px / pixels, detail = 0;
}

}  // namespace claque::frame
