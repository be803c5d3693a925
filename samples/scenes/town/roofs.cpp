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

Vec3 raised(Vec3 p) { return {p.x, p.y + static_cast<float>(roof_thickness_m), p.z}; }

// A slope between two corners of the eaves, seen from outside, and the ends of its ridge (one point for a triangle).
// Either the tiles above, or the shade below with the board at the eaves.
struct Slope {
    Vec3 left, right, ridge_right, ridge_left;
    bool pointed;
};

void lay(Geometry &g, const Site &s, const Slope &p, RoofPart part, Rgb colour)
{
    if (part == RoofPart::tiles) {
        if (p.pointed) s.face(g, {raised(p.left), raised(p.right), raised(p.ridge_left)}, colour, tiles_metres);
        else
            s.face(g, {raised(p.left), raised(p.right), raised(p.ridge_right), raised(p.ridge_left)}, colour,
                   tiles_metres);
        return;
    }
    if (p.pointed) s.face(g, {p.left, p.ridge_left, p.right}, colour * 0.42f, tiles_metres);
    else s.face(g, {p.left, p.ridge_left, p.ridge_right, p.right}, colour * 0.42f, tiles_metres);
    s.face(g, {p.left, p.right, raised(p.right), raised(p.left)}, colour * 0.62f, 40);
}

}  // namespace

void gable_roof(Geometry &g, const Site &s, const RoofShape &r, RoofPart part, Rgb colour)
{
    const double a = r.half_length + 0.8 * r.overhang, o = r.half_span + r.overhang;
    const double low = r.eaves - r.pitch * r.overhang, high = r.ridge(), t = roof_thickness_m;
    lay(g, s, {point(-a, low, o), point(a, low, o), point(a, high, 0), point(-a, high, 0), false}, part, colour);
    lay(g, s, {point(a, low, -o), point(-a, low, -o), point(-a, high, 0), point(a, high, 0), false}, part, colour);
    if (part == RoofPart::tiles) return;
    const Rgb board = colour * 0.62f;
    s.face(g, {point(a, low, o), point(a, high, 0), point(a, high + t, 0), point(a, low + t, o)}, board, 40);
    s.face(g, {point(a, high, 0), point(a, low, -o), point(a, low + t, -o), point(a, high + t, 0)}, board, 40);
    s.face(g, {point(-a, low, -o), point(-a, high, 0), point(-a, high + t, 0), point(-a, low + t, -o)}, board, 40);
    s.face(g, {point(-a, high, 0), point(-a, low, o), point(-a, low + t, o), point(-a, high + t, 0)}, board, 40);
}

void hip_roof(Geometry &g, const Site &s, const RoofShape &r, RoofPart part, Rgb colour)
{
    const double a = r.half_length + r.overhang, o = r.half_span + r.overhang, low = r.eaves - r.pitch * r.overhang;
    const double high = r.ridge(), half = std::max(0.3, r.half_length - r.half_span);
    for (const double side : {1.0, -1.0}) {
        lay(g, s,
            {point(-side * a, low, side * o), point(side * a, low, side * o), point(side * half, high, 0),
             point(-side * half, high, 0), false},
            part, colour);
        const Vec3 top = point(side * half, high, 0);
        lay(g, s, {point(side * a, low, side * o), point(side * a, low, -side * o), top, top, true}, part, colour);
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
