#include "samples/scenes/town/sun_shadows.h"

#include <algorithm>
#include <cmath>

namespace scenes::town
{
namespace
{

constexpr Rgb dark = {0.06f, 0.07f, 0.14f};
constexpr float darkness = 0.46f, lift_m = 0.012f;
constexpr double smallest_m2 = 0.05;

using Outline = std::vector<Point>;

double turn(Point a, Point b, Point c) { return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x); }

double area(const Outline &p)
{
    double twice = 0;
    for (size_t i = 0; i < p.size(); ++i) {
        const Point &a = p[i], &b = p[(i + 1) % p.size()];
        twice += a.x * b.z - a.z * b.x;
    }
    return std::abs(twice) / 2;
}

// Counter-clockwise, by Andrew's monotone chain.
Outline hull_of(Outline points)
{
    std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.z < b.z; });
    Outline hull;
    for (int pass = 0; pass < 2; ++pass) {
        const size_t first = hull.size();
        for (const Point &p : points) {
            while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 1e-9) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

// The part of a convex outline on the left of a -> b (side 1) or on its right (side -1).
Outline cut(const Outline &p, Point a, Point b, double side)
{
    Outline kept;
    for (size_t i = 0; i < p.size(); ++i) {
        const Point &from = p[i], &to = p[(i + 1) % p.size()];
        const double d0 = side * turn(a, b, from), d1 = side * turn(a, b, to);
        if (d0 >= 0) kept.push_back(from);
        if ((d0 > 0 && d1 < 0) || (d0 < 0 && d1 > 0)) {
            const double t = d0 / (d0 - d1);
            kept.push_back({from.x + t * (to.x - from.x), from.z + t * (to.z - from.z)});
        }
    }
    return kept.size() >= 3 && area(kept) > smallest_m2 ? kept : Outline{};
}

}  // namespace

SunShadows::SunShadows(Pieces &pieces, const Terrain &terrain, Vec3 to_sun)
    : pieces_(pieces), terrain_(terrain), to_sun_(to_sun)
{
}

void SunShadows::cast(const std::vector<Vec3> &points, double ground_y)
{
    Outline thrown;
    for (const Vec3 &p : points) {
        const double t = std::max(0.0, static_cast<double>(p.y) - ground_y) / static_cast<double>(to_sun_.y);
        thrown.push_back({static_cast<double>(p.x) - t * static_cast<double>(to_sun_.x),
                          static_cast<double>(p.z) - t * static_cast<double>(to_sun_.z)});
    }
    Shadow shadow = {hull_of(std::move(thrown)), 1e9, 1e9, -1e9, -1e9};
    if (shadow.outline.size() < 3) return;
    for (const Point &p : shadow.outline) {
        shadow.x0 = std::min(shadow.x0, p.x), shadow.x1 = std::max(shadow.x1, p.x);
        shadow.z0 = std::min(shadow.z0, p.z), shadow.z1 = std::max(shadow.z1, p.z);
    }
    std::vector<Outline> parts = {shadow.outline};
    for (const Shadow &other : cast_) {
        if (other.x0 > shadow.x1 || other.x1 < shadow.x0 || other.z0 > shadow.z1 || other.z1 < shadow.z0) continue;
        std::vector<Outline> left;
        for (Outline part : parts)
            for (size_t i = 0; i < other.outline.size() && !part.empty(); ++i) {
                const Point &a = other.outline[i], &b = other.outline[(i + 1) % other.outline.size()];
                Outline outside = cut(part, a, b, -1);
                if (!outside.empty()) left.push_back(std::move(outside));
                part = cut(part, a, b, 1);
            }
        parts = std::move(left);
    }
    for (const Outline &part : parts) lay(part);
    pieces_.finish(Piece::Kind::shade);
    cast_.push_back(std::move(shadow));
}

void SunShadows::lay(const Outline &part)
{
    double x0 = 1e9, z0 = 1e9, x1 = -1e9, z1 = -1e9;
    for (const Point &p : part) {
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
        z0 = std::min(z0, p.z), z1 = std::max(z1, p.z);
    }
    terrain_.find(x0, z0, x1, z1, found_);
    Geometry &g = pieces_.on(SurfaceKind::shade);
    for (const uint32_t number : found_) {
        const Terrain::Triangle t = terrain_.triangle(number);
        const Point corners[3] = {{t[0].x, t[0].z}, {t[2].x, t[2].z}, {t[1].x, t[1].z}};
        Outline inside = part;
        for (size_t i = 0; i < 3 && !inside.empty(); ++i) inside = cut(inside, corners[i], corners[(i + 1) % 3], 1);
        if (inside.empty()) continue;
        uint32_t first = 0;
        const double twice = turn(corners[0], corners[1], corners[2]);
        for (size_t i = 0; i < inside.size(); ++i) {
            const double w1 = turn(corners[0], inside[i], corners[2]) / twice;
            const double w2 = turn(corners[0], corners[1], inside[i]) / twice;
            const double y = static_cast<double>(t[0].y) * (1 - w1 - w2) + w1 * static_cast<double>(t[2].y) +
                             w2 * static_cast<double>(t[1].y);
            const uint32_t added = g.add(
                {static_cast<float>(inside[i].x), static_cast<float>(y) + lift_m, static_cast<float>(inside[i].z)},
                {0, 1, 0}, 0, 0, dark, darkness);
            if (i == 0) first = added;
            if (i >= 2) g.triangle(first, added, added - 1);
        }
    }
}

}  // namespace scenes::town
