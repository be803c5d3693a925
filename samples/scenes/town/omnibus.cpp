#include "samples/scenes/town/omnibus.h"

#include <cmath>

#include "samples/scenes/angles.h"

namespace scenes::town
{
namespace
{

}

void Omnibus::load(const Gl &gl, const Eye &eye, const std::array<float, 16> &model)
{
    float product[16];
    for (size_t column = 0; column < 4; ++column)
        for (size_t row = 0; row < 4; ++row) {
            double sum = 0;
            for (size_t k = 0; k < 4; ++k) sum += static_cast<double>(eye.view[4 * k + row]) * model[4 * column + k];
            product[4 * column + row] = static_cast<float>(sum);
        }
    gl.LoadMatrixf(product);
}

std::array<float, 16> Omnibus::wheel_matrix(const VehiclePose &pose, double end, double side)
{
    const double spin = std::fmod(pose.rolled_m / wheel_radius_m, two_pi), s = std::sin(spin), c = std::cos(spin);
    const double ss = end > 0 ? pose.steer_sin : 0, sc = end > 0 ? pose.steer_cos : 1;
    std::array<float, 16> m = {};
    for (size_t i = 0; i < 3; ++i) {
        const double x = pose.right_hand_x[i], y = pose.up[i], z = pose.forward[i];
        const double axle = sc * x - ss * z, ahead = ss * x + sc * z;  // the wheel's own, steered
        m[i] = static_cast<float>(side * axle);
        m[4 + i] = static_cast<float>(c * y + s * ahead);
        m[8 + i] = static_cast<float>(side * (c * ahead - s * y));
        m[12 + i] =
            static_cast<float>(pose.position[i] + side * 1.16 * x + wheel_radius_m * y + end * wheelbase_m / 2 * z);
    }
    m[15] = 1;
    return m;
}

void Omnibus::draw(const Gl &gl, const Eye &eye, const VehiclePose &pose) const
{
    constexpr double detail_m = 70;  // beyond this spokes are not visible
    load(gl, eye, pose.matrix());
    body_.draw(gl);
    const double dx = pose.position[0] - eye.position[0], dy = pose.position[1] - eye.position[1];
    const double dz = pose.position[2] - eye.position[2];
    const Geometry &wheel = dx * dx + dy * dy + dz * dz < detail_m * detail_m ? wheel_ : far_wheel_;
    for (const double end : {-1.0, 1.0})
        for (const double side : {-1.0, 1.0}) {
            load(gl, eye, wheel_matrix(pose, end, side));
            wheel.draw(gl);
        }
    gl.LoadMatrixf(eye.view);
}

void Omnibus::shade(Geometry &shadows, const VehiclePose &pose, Vec3 to_sun)
{
    constexpr Rgb dark = {0.06f, 0.07f, 0.14f};
    constexpr double high = 1.7, lift = 0.025;
    const auto corner = [&](double x, double z, float u, float v, float alpha) {
        const auto at = [&](size_t axis) {
            return static_cast<float>(pose.position[axis] + x * pose.right_hand_x[axis] + z * pose.forward[axis] +
                                      lift * pose.up[axis]);
        };
        return shadows.add({at(0), at(1), at(2)}, {0, 1, 0}, u, v, dark, alpha);
    };
    const auto fan = [&](uint32_t first, uint32_t count) {
        for (uint32_t i = 2; i < count; ++i) shadows.triangle(first, first + i - 1, first + i);
    };
    // The shadow of a box: its own ground plan, the same moved away from the sun, and the area between.
    const auto along = [&](const std::array<double, 3> &axis) {
        return -high * (static_cast<double>(to_sun.x) * axis[0] + static_cast<double>(to_sun.z) * axis[2]) /
               static_cast<double>(to_sun.y);
    };
    const double dx = along(pose.right_hand_x), dz = along(pose.forward);
    const double middle = (front_m + rear_m) / 2, x = dx < 0 ? -half_width_m : half_width_m;
    const double z = dz < 0 ? (rear_m - front_m) / 2 : (front_m - rear_m) / 2;
    const double outline[6][2] = {{-x, -z}, {x, -z}, {x + dx, -z + dz}, {x + dx, z + dz}, {-x + dx, z + dz}, {-x, z}};
    const uint32_t first = static_cast<uint32_t>(shadows.vertices().size());
    for (const auto &p : outline) corner(p[0], middle + p[1], 0.75f, 0.5f, 0.46f);
    fan(first, 6);
    // Adds the soft dark under it.
    const double wide = half_width_m + 0.6;
    const uint32_t under = corner(-wide, front_m + 0.5, 0.51f, 0.99f, 0.75f);
    corner(wide, front_m + 0.5, 0.99f, 0.99f, 0.75f);
    corner(wide, rear_m - 0.5, 0.99f, 0.01f, 0.75f);
    corner(-wide, rear_m - 0.5, 0.51f, 0.01f, 0.75f);
    fan(under, 4);
}

}  // namespace scenes::town
