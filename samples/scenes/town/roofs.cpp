#include "samples/scenes/town/roofs.h"

#include <algorithm>

namespace scenes::town
{
namespace
{

Vec3 point(double along, double y, double out)
{
    return {static_cast<float>(along), static_cast<float>(y), static_cast<float>(out)};
}

// A slope between two corners of the eaves, as seen from outside, and the two ends of its ridge: tiles above, shade
// below, the board at the eaves.
void slope(Geometry &g, const Site &s, Vec3 left, Vec3 right, Vec3 ridge_right, Vec3 ridge_left, Rgb colour)
{
    const auto up = [](Vec3 p) { return Vec3{p.x, p.y + static_cast<float>(roof_thickness_m), p.z}; };
    s.face(g, {up(left), up(right), up(ridge_right), up(ridge_left)}, colour, tiles_metres);
    s.face(g, {left, ridge_left, ridge_right, right}, colour * 0.42f, tiles_metres);
    s.face(g, {left, right, up(right), up(left)}, colour * 0.62f, 40);
}

}  // namespace

void gable_roof(Geometry &g, const Site &s, const RoofShape &r, Rgb colour)
{
    const double a = r.half_length + 0.8 * r.overhang, o = r.half_span + r.overhang;
    const double low = r.eaves - r.pitch * r.overhang, high = r.ridge(), t = roof_thickness_m;
    slope(g, s, point(-a, low, o), point(a, low, o), point(a, high, 0), point(-a, high, 0), colour);
    slope(g, s, point(a, low, -o), point(-a, low, -o), point(-a, high, 0), point(a, high, 0), colour);
    const Rgb board = colour * 0.62f;
    s.face(g, {point(a, low, o), point(a, high, 0), point(a, high + t, 0), point(a, low + t, o)}, board, 40);
    s.face(g, {point(a, high, 0), point(a, low, -o), point(a, low + t, -o), point(a, high + t, 0)}, board, 40);
    s.face(g, {point(-a, low, -o), point(-a, high, 0), point(-a, high + t, 0), point(-a, low + t, -o)}, board, 40);
    s.face(g, {point(-a, high, 0), point(-a, low, o), point(-a, low + t, o), point(-a, high + t, 0)}, board, 40);
}

void hip_roof(Geometry &g, const Site &s, const RoofShape &r, Rgb colour)
{
    const double a = r.half_length + r.overhang, o = r.half_span + r.overhang, low = r.eaves - r.pitch * r.overhang;
    const double high = r.ridge(), half = std::max(0.3, r.half_length - r.half_span);
    slope(g, s, point(-a, low, o), point(a, low, o), point(half, high, 0), point(-half, high, 0), colour);
    slope(g, s, point(a, low, -o), point(-a, low, -o), point(-half, high, 0), point(half, high, 0), colour);
    for (const double side : {1.0, -1.0}) {
        const float t = static_cast<float>(roof_thickness_m);
        Vec3 left = point(side * a, low, side * o), right = point(side * a, low, -side * o);
        Vec3 top = point(side * half, high, 0);
        s.face(g, {left, top, right}, colour * 0.42f, tiles_metres);
        Vec3 left_up = left, right_up = right;
        left_up.y += t, right_up.y += t, top.y += t;
        s.face(g, {left_up, right_up, top}, colour, tiles_metres);
        s.face(g, {left, right, right_up, left_up}, colour * 0.62f, 40);
    }
}

void gable_walls(Geometry &g, const Site &s, const RoofShape &r, Rgb colour, Bay bay)
{
    const BayBox box = box_of(bay);
    for (const double side : {1.0, -1.0}) {
        const Point out = s.along();
        const Vec3 normal = {static_cast<float>(side * out.x), 0, static_cast<float>(side * out.z)};
        const uint32_t first =
            g.add(s.at(side * r.half_length, r.eaves, side * r.half_span), normal, box.u0, box.v0, colour);
        g.add(s.at(side * r.half_length, r.eaves, -side * r.half_span), normal, box.u1, box.v0, colour);
        g.add(s.at(side * r.half_length, r.ridge(), 0), normal, (box.u0 + box.u1) / 2, box.v1, colour);
        g.triangle(first, first + 1, first + 2);
    }
}

}  // namespace scenes::town
