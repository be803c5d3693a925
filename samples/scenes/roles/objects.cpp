#include "samples/scenes/roles/objects.h"

#include <algorithm>
#include <cmath>

namespace scenes::roles
{
namespace
{

constexpr Rgb wood = {0.48f, 0.33f, 0.19f}, straw = {0.78f, 0.66f, 0.38f}, flame = {0.98f, 0.66f, 0.16f},
              bronze = {0.72f, 0.52f, 0.26f};
constexpr float belt_half_m = 0.45f, belt_ahead_m = 1.6f, belt_y_m = 0.004f;
constexpr double slat_m = 0.25;

struct Object {
    const char *name;
    float radius;
    Geometry shape;
};

Geometry staff()
{
    Geometry g;
    g.turned(0, 0, {{0.018f, -0.95f}, {0.016f, 0.75f}, {0.03f, 0.78f}, {0.028f, 0.84f}, {0, 0.86f}}, 10, wood);
    return g;
}

Geometry torch()
{
    Geometry g;
    g.turned(0, 0, {{0, -0.25f}, {0.018f, -0.25f}, {0.028f, 0.22f}, {0.05f, 0.3f}, {0, 0.3f}}, 10, wood);
    g.turned(0, 0, {{0.045f, 0.3f}, {0.06f, 0.36f}, {0.035f, 0.46f}, {0, 0.56f}}, 10, flame);
    return g;
}

Geometry basket()
{
    Geometry g;
    g.turned(0, 0, {{0, -0.30f}, {0.13f, -0.30f}, {0.19f, -0.12f}, {0.20f, -0.10f}, {0.17f, -0.11f}, {0, -0.12f}}, 16,
             straw);
    return g;
}

Geometry ball()
{
    Geometry g;
    std::vector<Geometry::Ring> rings;
    for (int k = 0; k <= 10; ++k) {
        const double turn = 3.14159265358979 * (k / 10.0 - 0.5);
        rings.push_back({static_cast<float>(0.11 * std::cos(turn)), static_cast<float>(0.11 * std::sin(turn))});
    }
    g.turned(0, 0, rings, 16, bronze);
    return g;
}

const std::vector<Object> &objects()
{
    static const std::vector<Object> all = {
        {"staff", 0.96f, staff()}, {"torch", 0.57f, torch()}, {"basket", 0.37f, basket()}, {"ball", 0.12f, ball()}};
    return all;
}

const Object *object_named(const std::string &name)
{
    for (const Object &object : objects())
        if (name == object.name) return &object;
    return nullptr;
}

// Model-view for a place whose axes are columns of length 1.
void place(const Gl &g, const Eye &eye, const std::array<std::array<double, 3>, 3> &axes,
           const std::array<double, 3> &at)
{
    float m[16] = {};
    const auto put = [&](const std::array<double, 3> &v, size_t column) {
        for (size_t row = 0; row < 3; ++row)
            for (size_t k = 0; k < 3; ++k) m[4 * column + row] += eye.rotation[4 * k + row] * static_cast<float>(v[k]);
    };
    for (size_t column = 0; column < 3; ++column) put(axes[column], column);
    put({at[0] - eye.position[0], at[1] - eye.position[1], at[2] - eye.position[2]}, 3);
    m[15] = 1;
    g.MatrixMode(gl::projection);
    g.LoadMatrixf(eye.projection);
    g.MatrixMode(gl::modelview);
    g.LoadMatrixf(m);
}

std::array<std::array<double, 3>, 3> upright(double heading_rad)
{
    const double s = std::sin(heading_rad), c = std::cos(heading_rad);
    return {{{c, 0, -s}, {0, 1, 0}, {s, 0, c}}};
}

// With the lights as the surroundings left them.
void draw_shape(const Gl &g, const Geometry &shape)
{
    g.Disable(gl::texture_2d);
    shape.draw(g);
}

Vec3 vec(double x, double y, double z) { return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}; }

}  // namespace

const std::vector<std::string> &object_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Object &object : objects()) all.emplace_back(object.name);
        return all;
    }();
    return names;
}

bool is_object(const std::string &name) { return object_named(name) != nullptr; }

float radius_of_object(const std::string &name)
{
    const Object *object = object_named(name);
    return object ? object->radius : 0;
}

void draw_object(const Gl &g, const Eye &eye, const std::string &name, const double (&node)[16])
{
    const Object *object = object_named(name);
    if (!object) return;
    std::array<std::array<double, 3>, 3> axes;
    for (size_t column = 0; column < 3; ++column) {
        const double *axis = node + 4 * column;
        const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        for (size_t k = 0; k < 3; ++k) axes[column][k] = axis[k] / std::max(1e-9, length);
    }
    place(g, eye, axes, {node[12], node[13], node[14]});
    draw_shape(g, object->shape);
}

void draw_belt(const Gl &g, const Eye &eye, const std::array<double, 3> &at, double heading_rad, double moved_m)
{
    Geometry belt;
    const auto strip = [&](double first, double last, Rgb colour) {
        const double low = std::max(first, -static_cast<double>(belt_ahead_m)),
                     high = std::min(last, static_cast<double>(belt_ahead_m));
        if (low >= high) return;
        const double half = static_cast<double>(belt_half_m), y = static_cast<double>(belt_y_m);
        belt.quad({vec(-half, y, low), vec(-half, y, high), vec(half, y, high), vec(half, y, low)}, colour);
    };
    // Slats move towards the person's back.
    const double turn = moved_m / (2 * slat_m), offset = (turn - std::floor(turn)) * 2 * slat_m;
    for (int k = -8; k < 9; ++k) {
        const double first = 2 * slat_m * k - offset;
        strip(first, first + slat_m, {0.34f, 0.35f, 0.37f});
        strip(first + slat_m, first + 2 * slat_m, {0.44f, 0.45f, 0.47f});
    }
    const float y = belt_y_m, half = belt_half_m, ahead = belt_ahead_m, rail = 0.05f;
    for (const float side : {-half - rail, half})
        belt.box({side, y, -ahead}, {side + rail, y + 0.03f, ahead}, {0.62f, 0.50f, 0.20f});
    place(g, eye, upright(heading_rad), at);
    // It lies on the ground of the scene.
    g.Enable(gl::polygon_offset_fill);
    g.PolygonOffset(-2, -4);
    draw_shape(g, belt);
    g.Disable(gl::polygon_offset_fill);
}

void draw_target(const Gl &g, const Eye &eye, const std::array<double, 3> &at)
{
    Geometry cross;
    constexpr float arm = 0.05f, thin = 0.006f;
    const Rgb red = {0.86f, 0.16f, 0.12f};
    cross.box({-arm, -thin, -thin}, {arm, thin, thin}, red);
    cross.box({-thin, -arm, -thin}, {thin, arm, thin}, red);
    cross.box({-thin, -thin, -arm}, {thin, thin, arm}, red);
    place(g, eye, upright(0), at);
    draw_shape(g, cross);
}

void draw_way(const Gl &g, const Eye &eye, const std::vector<double> &corners)
{
    const size_t count = corners.size() / 3;
    if (count == 0) return;
    Geometry way;
    const double *first = corners.data();
    constexpr int parts = 16;
    for (size_t i = 0; i < count; ++i)
        for (int part = 0; part < (count > 2 ? parts : 1); ++part) {
            const double t = static_cast<double>(part) / parts;
            double p[3];
            for (size_t k = 0; k < 3; ++k) {  // Catmull-Rom, as flights go
                const double p0 = corners[3 * ((i + count - 1) % count) + k], p1 = corners[3 * i + k];
                const double p2 = corners[3 * ((i + 1) % count) + k], p3 = corners[3 * ((i + 2) % count) + k];
                p[k] = p1 + t / 2 * (p2 - p0 + t * (2 * p0 - 5 * p1 + 4 * p2 - p3 + t * (3 * (p1 - p2) + p3 - p0)));
                p[k] -= first[k];
            }
            const float half = part == 0 ? 0.05f : 0.02f;
            const Vec3 at = vec(p[0], p[1], p[2]);
            way.box({at.x - half, at.y - half, at.z - half}, {at.x + half, at.y + half, at.z + half},
                    part == 0 ? Rgb{0.86f, 0.16f, 0.12f} : Rgb{0.95f, 0.75f, 0.20f});
        }
    place(g, eye, upright(0), {first[0], first[1], first[2]});
    draw_shape(g, way);
}

}  // namespace scenes::roles
