#include "samples/scenes/town/site.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scenes::town
{
namespace
{

Vec3 minus(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Vec3 unit(Vec3 v)
{
    const float k = 1 / std::sqrt(dot(v, v));
    return {v.x * k, v.y * k, v.z * k};
}

}  // namespace

Vec3 Site::at(double along, double y, double out) const
{
    const Point p = ground(along, out);
    return {static_cast<float>(p.x), static_cast<float>(y), static_cast<float>(p.z)};
}

Point Site::ground(double along, double out) const
{
    return {at_.x + out_.z * along + out_.x * out, at_.z - out_.x * along + out_.z * out};
}

void Site::face(Geometry &g, std::initializer_list<Vec3> corners, Rgb colour, float metres) const
{
    std::vector<Vec3> p;
    for (const Vec3 &c : corners) p.push_back(at(c.x, c.y, c.z));
    const Vec3 normal = unit(cross(minus(p[1], p[0]), minus(p.back(), p[0])));
    // Up the face, as steep as it goes; on a horizontal face along its first edge.
    const Vec3 level = std::abs(normal.y) > 0.999f ? unit(minus(p[1], p[0])) : unit(cross({0, 1, 0}, normal));
    const Vec3 up = cross(normal, level);
    uint32_t first = 0;
    for (size_t i = 0; i < p.size(); ++i) {
        const Vec3 from = minus(p[i], p[0]);
        const uint32_t added = g.add(p[i], normal, dot(from, level) / metres, dot(from, up) / metres, colour);
        if (i == 0) first = added;
        if (i >= 2) g.triangle(first, added - 1, added);
    }
}

BayBox box_of(Bay bay)
{
    constexpr float cell = 1.0f / bays_each_way, inset = 4.0f / 1024;  // keeps neighbours out of the filter
    const int number = static_cast<int>(bay);
    const float u = static_cast<float>(number % bays_each_way) * cell;
    const float v = static_cast<float>(number / bays_each_way) * cell;
    return {u + inset, v + inset, u + cell - inset, v + cell - inset};
}

void Site::bay(Geometry &g, const Upright &w, double left_low, double right_low, double high, Bay bay, Rgb colour,
               double whole_m) const
{
    const Vec3 a = at(w.left_along, left_low, w.left_out), b = at(w.right_along, right_low, w.right_out);
    const Vec3 c = at(w.right_along, high, w.right_out), d = at(w.left_along, high, w.left_out);
    const Vec3 normal = unit(cross(minus({b.x, a.y, b.z}, a), {0, 1, 0}));
    const BayBox box = box_of(bay);
    const auto low = [&](double y) {
        const double share = whole_m > 0 ? std::min(1.0, (high - y) / whole_m) : 1.0;
        return box.v1 - static_cast<float>(share) * (box.v1 - box.v0);
    };
    const uint32_t i = g.add(a, normal, box.u0, low(left_low), colour);
    g.add(b, normal, box.u1, low(right_low), colour);
    g.add(c, normal, box.u1, box.v1, colour);
    g.add(d, normal, box.u0, box.v1, colour);
    g.triangle(i, i + 1, i + 2);
    g.triangle(i, i + 2, i + 3);
}

void Site::box(Geometry &g, Vec3 a, Vec3 b, Rgb colour, float metres) const
{
    face(g, {{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}}, colour, metres);
    face(g, {{b.x, a.y, b.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}}, colour, metres);
    face(g, {{b.x, a.y, a.z}, {a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}}, colour, metres);
    face(g, {{a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}}, colour, metres);
    face(g, {{a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z}}, colour, metres);
}

}  // namespace scenes::town
