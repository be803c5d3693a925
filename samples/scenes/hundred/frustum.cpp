#include "samples/scenes/hundred/frustum.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/eye.h"

namespace scenes::hundred
{
namespace
{

constexpr double eye_at[3] = {0, 20, 0}, target_at[3] = {0, 30, -100};
constexpr double fov_y_deg = 46, z_near = 1, z_far = 6000, aspect_of_table = 4.0 / 3.0;

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace

clq_camera Frustum::camera(double aspect) { return look(eye_at, target_at, fov_y_deg, aspect, z_near, z_far); }

Point Frustum::eye() { return {eye_at[0], eye_at[1], eye_at[2]}; }

Frustum::Frustum()
{
    ahead_ = unit(Point{target_at[0], target_at[1], target_at[2]} - eye());
    right_ = unit(cross(ahead_, {0, 1, 0}));
    up_ = cross(right_, ahead_);
    const double half = fov_y_deg * 3.141592653589793 / 360;
    tan_y_ = std::sin(half) / std::cos(half);
    tan_x_ = tan_y_ * aspect_of_table;
    normals_ = {unit(right_ - ahead_ * tan_x_), unit(right_ * -1 - ahead_ * tan_x_), unit(up_ - ahead_ * tan_y_),
                unit(up_ * -1 - ahead_ * tan_y_)};
}

Point Frustum::at(double ahead, double right, double up) const
{
    return eye() + ahead_ * ahead + right_ * right + up_ * up;
}

Point Frustum::beside(double side, double ahead, double out, double up) const
{
    return at(ahead, side * (ahead * tan_x_ + std::sqrt(1 + tan_x_ * tan_x_) * out), up);
}

Point Frustum::normal(double side) const { return normals_[side > 0 ? 0 : 1]; }

double Frustum::out_but(double side, Point centre) const
{
    const Point from = centre - eye();
    double most = z_near - dot(ahead_, from);
    for (size_t k = 0; k < normals_.size(); ++k)
        if (side == 0 || k != (side > 0 ? 0u : 1u)) most = std::max(most, dot(normals_[k], from));
    return most;
}

Lies Frustum::test(Point centre, double radius) const
{
    const double out = out_but(0, centre);
    return out > radius ? Lies::outside : out < -radius ? Lies::within : Lies::across;
}

double Frustum::reach(Point p) const
{
    const Point from = p - eye();
    return std::sqrt(dot(from, from));
}

}  // namespace scenes::hundred
