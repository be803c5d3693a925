// Woods of the town and its hills, parcel by parcel; what is random is a hash of the parcel.
#include <algorithm>
#include <cmath>

#include "samples/scenes/odeon/noise.h"
#include "samples/scenes/random.h"
#include "samples/scenes/town/ground.h"

namespace scenes::town
{
namespace
{

constexpr Rgb deciduous = {0.38f, 0.54f, 0.25f}, spruce = {0.25f, 0.41f, 0.24f};
constexpr float metres = 13;  // of a repeat of the leaves, which represent crowns here

class Forester
{
public:
    Forester(Pieces &pieces, const Plan &plan, const Terrain &terrain, uint64_t seed)
        : pieces_(pieces), plan_(plan), terrain_(terrain), seed_(seed)
    {
    }

    void cell(size_t i, size_t k)
    {
        const Vec3 &a = terrain_.corner(i, k), &b = terrain_.corner(i + 1, k), &d = terrain_.corner(i, k + 1);
        const double far = std::sqrt(static_cast<double>(a.x) * a.x + static_cast<double>(a.z) * a.z);
        const int across = parts(a, b, far), down = parts(a, d, far);
        const double share = random_unit(seed_, plan_.parcel(i, k), Purpose::temper);
        const Rgb green = share < 0.6 ? deciduous : spruce;
        const auto wood = [&](size_t column, size_t row) {
            return column < terrain_.columns() && row < terrain_.rows() && plan_.cover(column, row) == Cover::wood;
        };
        const bool open[4] = {!wood(i, k + 1), !wood(i + 1, k), !wood(i, k - 1), !wood(i - 1, k)};
        Geometry &g = pieces_.on(SurfaceKind::leaves);
        const uint32_t first = static_cast<uint32_t>(g.vertices().size());
        for (int n = 0; n <= down; ++n)
            for (int m = 0; m <= across; ++m)
                top(g, edged(i, k, m, n, across, down, open),
                    (m == 0 && open[3]) || (m == across && open[1]) || (n == 0 && open[2]) || (n == down && open[0]),
                    green);
        const uint32_t wide = static_cast<uint32_t>(across) + 1;
        const auto number = [&](int m, int n) {
            return first + static_cast<uint32_t>(n) * wide + static_cast<uint32_t>(m);
        };
        for (int n = 0; n < down; ++n)
            for (int m = 0; m < across; ++m) {
                g.triangle(number(m, n + 1), number(m + 1, n + 1), number(m + 1, n));
                g.triangle(number(m, n + 1), number(m + 1, n), number(m, n));
            }
        for (int m = 0; m < across; ++m) {
            if (open[0]) side(g, number(m, down), number(m + 1, down), green);
            if (open[2]) side(g, number(m + 1, 0), number(m, 0), green);
        }
        for (int n = 0; n < down; ++n) {
            if (open[1]) side(g, number(across, n + 1), number(across, n), green);
            if (open[3]) side(g, number(0, n), number(0, n + 1), green);
        }
    }

private:
    static int parts(const Vec3 &a, const Vec3 &b, double far)
    {
        const double x = static_cast<double>(b.x) - a.x, z = static_cast<double>(b.z) - a.z;
        return std::clamp(static_cast<int>(std::sqrt(x * x + z * z) / (15 + far * 0.08) + 0.5), far < 900 ? 2 : 1, 8);
    }

    Point within(size_t i, size_t k, double s, double t) const
    {
        const Vec3 &a = terrain_.corner(i, k), &b = terrain_.corner(i + 1, k);
        const Vec3 &c = terrain_.corner(i + 1, k + 1), &d = terrain_.corner(i, k + 1);
        const auto mix = [&](float pa, float pb, float pc, float pd) {
            return (static_cast<double>(pa) * (1 - s) + static_cast<double>(pb) * s) * (1 - t) +
                   (static_cast<double>(pd) * (1 - s) + static_cast<double>(pc) * s) * t;
        };
        return {mix(a.x, b.x, c.x, d.x), mix(a.z, b.z, c.z, d.z)};
    }

    // A point of the roof; on an open edge moved inwards at random, so that woods have no straight outline.
    Point edged(size_t i, size_t k, int m, int n, int across, int down, const bool (&open)[4]) const
    {
        double s = m, t = n;
        const Point p = within(i, k, s / across, t / down);
        const double in = std::clamp(0.38 + 0.75 * gradient_noise(seed_ + 75, p.x / 23, p.z / 23), 0.02, 0.72);
        if (across > 1) s += m == 0 && open[3] ? in : m == across && open[1] ? -in : 0;
        if (down > 1) t += n == 0 && open[2] ? in : n == down && open[0] ? -in : 0;
        return within(i, k, s / across, t / down);
    }

    void top(Geometry &g, Point p, bool edge, Rgb green) const
    {
        const double crowns = gradient_noise(seed_ + 71, p.x / 21.7, p.z / 21.7);
        const double broad = gradient_noise(seed_ + 72, p.x / 90, p.z / 90);
        const double nx = gradient_noise(seed_ + 73, p.x / 17.3, p.z / 17.3);
        const double nz = gradient_noise(seed_ + 74, p.x / 17.3, p.z / 17.3);
        const double length = std::sqrt(nx * nx + nz * nz + 1);
        const float light = static_cast<float>(0.86 + 0.30 * crowns + 0.22 * broad);
        g.add({static_cast<float>(p.x),
               static_cast<float>(terrain_.height(p.x, p.z) + (edge ? 5.0 : 10.5) + 4.5 * crowns + 2 * broad),
               static_cast<float>(p.z)},
              {static_cast<float>(nx / length), static_cast<float>(1 / length), static_cast<float>(nz / length)},
              static_cast<float>(p.x) / metres, static_cast<float>(p.z) / metres, green * light);
    }

    // The edge of the wood between two of its upper corners, left and right as seen from outside.
    void side(Geometry &g, uint32_t left, uint32_t right, Rgb green) const
    {
        const Vec3 l = g.vertices()[left].position, r = g.vertices()[right].position;
        const float x = r.x - l.x, z = r.z - l.z, length = std::sqrt(x * x + z * z);
        const Vec3 out = {-z / length, 0.25f, x / length};
        const auto foot = [&](const Vec3 &p, float u) {
            const float y = static_cast<float>(terrain_.height(p.x, p.z)) - 0.03f;
            return g.add({p.x, y, p.z}, out, u, 0, green * 0.42f);
        };
        const float wide = length / metres;
        const uint32_t a = foot(l, 0), b = foot(r, wide);
        const uint32_t c = g.add(r, out, wide, 0.8f, green * 0.9f), d = g.add(l, out, 0, 0.8f, green * 0.9f);
        g.triangle(a, b, c);
        g.triangle(a, c, d);
    }

    Pieces &pieces_;
    const Plan &plan_;
    const Terrain &terrain_;
    uint64_t seed_;
};

}  // namespace

void grow_woods(Pieces &pieces, const Plan &plan, const Terrain &terrain, uint64_t seed)
{
    constexpr size_t patch = 6;
    Forester forester(pieces, plan, terrain, seed);
    for (size_t row = 0; row < terrain.rows(); row += patch)
        for (size_t column = 0; column < terrain.columns(); column += patch) {
            for (size_t k = row; k < std::min(row + patch, terrain.rows()); ++k)
                for (size_t i = column; i < std::min(column + patch, terrain.columns()); ++i)
                    if (plan.cover(i, k) == Cover::wood) forester.cell(i, k);
            pieces.finish(Piece::Kind::wood);
        }
}

}  // namespace scenes::town
