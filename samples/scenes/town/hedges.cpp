// Hedges between the gardens behind the houses.
#include <algorithm>
#include <cmath>

#include "samples/scenes/random.h"
#include "samples/scenes/town/trees.h"

namespace scenes::town
{
namespace
{

constexpr Rgb hedge_green = {0.36f, 0.52f, 0.24f};
constexpr double high_m = 1.25, half_m = 0.4, gate_m = 2.6;

bool in_house(const std::vector<House> &houses, Point p)
{
    for (const House &h : houses) {
        const double x = p.x - h.at.x, z = p.z - h.at.z;
        if (std::abs(x * h.out.x + z * h.out.z) < h.depth_m / 2 + 1 &&
            std::abs(x * h.out.z - z * h.out.x) < h.width_m / 2 + 1)
            return true;
    }
    return false;
}

// From one point of the ground to another: two sides and a top that follow the ground, and two ends.
void hedge(Pieces &pieces, const Terrain &terrain, Point a, Point b)
{
    const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.z - a.z) * (b.z - a.z));
    const double dx = (b.x - a.x) / length, dz = (b.z - a.z) / length;
    const auto corner = [&](Point p, double side, double up) {
        const double x = p.x - dz * half_m * side, z = p.z + dx * half_m * side;
        return Vec3{static_cast<float>(x), static_cast<float>(terrain.height(x, z) + (up > 0 ? up : -0.03)),
                    static_cast<float>(z)};
    };
    const Vec3 a0 = corner(a, 1, 0), a1 = corner(a, 1, high_m), a2 = corner(a, -1, high_m), a3 = corner(a, -1, 0);
    const Vec3 b0 = corner(b, 1, 0), b1 = corner(b, 1, high_m), b2 = corner(b, -1, high_m), b3 = corner(b, -1, 0);
    Geometry &g = pieces.on(SurfaceKind::leaves);
    g.quad({a0, b0, b1, a1}, hedge_green * 0.8f);
    g.quad({b3, a3, a2, b2}, hedge_green * 0.8f);
    g.quad({a1, b1, b2, a2}, hedge_green * 1.15f);
    pieces.from_now(Visibility::near);
    g.quad({a3, a0, a1, a2}, hedge_green * 0.8f);
    g.quad({b0, b3, b2, b1}, hedge_green * 0.8f);
}

}  // namespace

void plant_hedges(Pieces &pieces, const Plan &plan, const Terrain &terrain, const std::vector<House> &houses,
                  uint64_t seed)
{
    const std::vector<double> u = plan.lines_u(), v = plan.lines_v();
    const auto garden = [&](size_t i, size_t k) { return plan.cover(i, k) == Cover::garden; };
    const auto between = [&](double u0, double v0, double u1, double v1, uint64_t number) {
        if (random_unit(seed, number, Purpose::gap) > 0.45) return;
        const double du = u1 - u0, dv = v1 - v0, length = std::sqrt(du * du + dv * dv), t = gate_m / 2 / length;
        const Point a = plan.at(u0 + du * t, v0 + dv * t), b = plan.at(u1 - du * t, v1 - dv * t);
        for (int i = 0; i <= 6; ++i)
            if (in_house(houses, {a.x + (b.x - a.x) * i / 6, a.z + (b.z - a.z) * i / 6})) return;
        hedge(pieces, terrain, a, b);
        pieces.finish(Piece::Kind::tree);
    };
    for (size_t k = 1; k < terrain.rows(); ++k)
        for (size_t i = 1; i < terrain.columns(); ++i) {
            if (!garden(i, k)) continue;
            const uint64_t number = (i * 4096 + k) * 2;
            if (garden(i - 1, k)) between(u[i], v[k], u[i], v[k + 1], number);
            if (garden(i, k - 1)) between(u[i], v[k], u[i + 1], v[k], number + 1);
        }
}

}  // namespace scenes::town
