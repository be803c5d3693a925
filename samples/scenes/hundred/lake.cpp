#include "samples/scenes/hundred/lake.h"

#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/random.h"

namespace scenes::hundred
{
namespace
{

constexpr Rgb deep = {0.10f, 0.34f, 0.42f}, calm = {0.30f, 0.54f, 0.60f};
constexpr Rgb stone = {0.46f, 0.45f, 0.42f}, moss = {0.33f, 0.42f, 0.24f}, pine = {0.16f, 0.33f, 0.20f},
              trunk = {0.34f, 0.24f, 0.18f};

Rgb mix(Rgb a, Rgb b, double t)
{
    const float k = static_cast<float>(t);
    return {a.r + (b.r - a.r) * k, a.g + (b.g - a.g) * k, a.b + (b.b - a.b) * k};
}

Vec3 at(double x, double y, double z) { return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}; }

void add_water(Geometry &water)
{
    constexpr int sides = 64;
    constexpr double radii[] = {0.5, 40, 90, 160, 260, 420, 700, 1200, 2200, 4200};
    uint32_t before = 0;
    for (size_t ring = 0; ring < std::size(radii); ++ring) {
        const double far = radii[ring] / (radii[ring] + 260);
        const Rgb colour = far < 0.5 ? mix(deep, calm, 2 * far) : mix(calm, lake_haze, 2 * far - 1);
        uint32_t first = 0;
        for (int k = 0; k <= sides; ++k) {
            const double turn = two_pi * k / sides;
            const uint32_t v = water.add(at(radii[ring] * std::sin(turn), 0, radii[ring] * std::cos(turn)), {0, 1, 0},
                                         0, 0, colour * 1.12f);
            if (k == 0) first = v;
            if (ring == 0 || k == 0) continue;
            const uint32_t inner = before + static_cast<uint32_t>(k);
            water.triangle(inner - 1, v - 1, v);
            water.triangle(inner - 1, v, inner);
        }
        before = first;
    }
}

struct Rock {
    double x, z, size, high;                               // high: times its size
    double top() const { return 0.86 * high * size + 5; }  // of its trees
};

void add_rock(Geometry &rocks, const Rock &rock, uint64_t seed, uint64_t number)
{
    const float fx = static_cast<float>(rock.x), fz = static_cast<float>(rock.z), s = static_cast<float>(rock.size);
    const float high = static_cast<float>(rock.high);
    rocks.turned(fx, fz, {{1.0f * s, -0.5f}, {0.92f * s, 0.25f * high * s}, {0.70f * s, 0.62f * high * s}}, 9, stone);
    rocks.turned(fx, fz, {{0.72f * s, 0.60f * high * s}, {0.50f * s, 0.80f * high * s}, {0.0f, 0.86f * high * s}}, 9,
                 moss);
    for (uint64_t k = 0; k < 3; ++k) {
        const uint64_t tree = number * 8 + k;
        const double turn = random_between(seed, tree, Purpose::tree, 0, two_pi),
                     out = 0.42 * rock.size * static_cast<double>(k + 1) / 3;
        const float tx = static_cast<float>(rock.x + out * std::sin(turn)),
                    tz = static_cast<float>(rock.z + out * std::cos(turn));
        const float foot = 0.76f * high * s,
                    tall = static_cast<float>(random_between(seed, tree, Purpose::radius, 2.6, 5.0));
        rocks.turned(tx, tz, {{0.22f, foot}, {0.16f, foot + 0.4f * tall}}, 5, trunk);
        for (int tier = 0; tier < 3; ++tier) {
            const float low = foot + tall * (0.28f + 0.24f * static_cast<float>(tier)),
                        wide = 0.34f * tall * (1 - 0.26f * static_cast<float>(tier));
            rocks.turned(tx, tz, {{wide, low}, {0.0f, low + 0.36f * tall}}, 7,
                         pine * (0.9f + 0.14f * static_cast<float>(tier)));
        }
    }
}

bool is_clear(const Rock &rock, const std::vector<Spot> &spots, const Spheres &spheres)
{
    constexpr double below_m = 3;  // the lowest point of a dragon
    for (const Spot &spot : spots) {
        const double dx = rock.x - spot.place.position[0], dz = rock.z - spot.place.position[2];
        const double reach = spheres.refpoint[static_cast<size_t>(spot.way)] + rock.size;
        if (dx * dx + dz * dz < reach * reach && spot.place.position[1] - below_m < rock.top()) return false;
    }
    return true;
}

}  // namespace

void fill_lake(Geometry &water, Geometry &rocks, const std::vector<Spot> &spots, const Spheres &spheres, uint64_t seed)
{
    add_water(water);
    // Away from the eye, larger with the distance.
    for (uint64_t number = 0; number < 60; ++number) {
        const double far =
            70 + 420 * random_unit(seed, number, Purpose::place_x) * random_unit(seed, number, Purpose::row);
        const double turn = random_between(seed, number, Purpose::heading, -1.5, 1.5);
        const Rock rock = {far * std::sin(turn), -far * std::cos(turn),
                           random_between(seed, number, Purpose::gap, 3, 6) * (0.6 + far / 240),
                           random_between(seed, number, Purpose::size, 0.8, 2.2)};
        if (is_clear(rock, spots, spheres)) add_rock(rocks, rock, seed, number);
    }
}

namespace
{

constexpr Rgb row_colours[] = {{0.35f, 0.35f, 0.38f}, {0.20f, 0.62f, 0.25f}, {0.90f, 0.55f, 0.12f},
                               {0.62f, 0.80f, 0.18f}, {0.15f, 0.75f, 0.75f}, {0.75f, 0.20f, 0.62f},
                               {0.90f, 0.12f, 0.10f}};

void add_ring(Geometry &plan, double x, double z, double radius, double wide, Rgb colour, float alpha)
{
    constexpr uint32_t sides = 48;
    uint32_t inner = 0, outer = 0;
    for (uint32_t k = 0; k <= sides; ++k) {
        const double turn = two_pi * k / sides, s = std::sin(turn), c = std::cos(turn);
        const uint32_t a =
            plan.add(at(x + (radius - wide) * s, 0.1, z + (radius - wide) * c), {0, 1, 0}, 0, 0, colour, alpha);
        const uint32_t b = plan.add(at(x + radius * s, 0.1, z + radius * c), {0, 1, 0}, 0, 0, colour, alpha);
        if (k > 0) plan.triangle(inner, outer, b), plan.triangle(inner, b, a);
        inner = a, outer = b;
    }
}

// Between two points on the water.
void add_line(Geometry &plan, Point from, Point to, double wide, Rgb colour, float alpha)
{
    const Point aside = unit(cross(to - from, {0, 1, 0})) * (0.5 * wide);
    const auto corner = [&](Point p) { return plan.add(at(p.x, p.y, p.z), {0, 1, 0}, 0, 0, colour, alpha); };
    const uint32_t a = corner(from + aside), b = corner(from - aside), c = corner(to - aside), d = corner(to + aside);
    plan.triangle(a, c, b), plan.triangle(a, d, c);
}

}  // namespace

void draw_plan(Geometry &plan, const std::vector<Spot> &spots, const Spheres &spheres)
{
    constexpr Rgb light = {1.0f, 0.95f, 0.70f};
    const Frustum frustum;
    const Point foot = {Frustum::eye().x, 0.06, Frustum::eye().z};
    const auto far_end = [&](double side) {
        Point end = frustum.beside(side, 300, 0, 0);
        end.y = 0.06;
        return end;
    };
    const auto corner = [&](Point p) { return plan.add(at(p.x, 0.05, p.z), {0, 1, 0}, 0, 0, light, 0.28f); };
    const uint32_t a = corner(foot), b = corner(far_end(1)), c = corner(far_end(-1));
    plan.triangle(a, b, c);
    for (const double side : {1.0, -1.0}) add_line(plan, foot, far_end(side), 1.2, light, 0.9f);
    for (const Spot &spot : spots) {
        const Rgb colour = row_colours[static_cast<size_t>(spot.row)];
        const double radius = spheres.refpoint[static_cast<size_t>(spot.way)];
        add_ring(plan, spot.place.position[0], spot.place.position[2], radius, 0.9, colour, 0.95f);
        add_ring(plan, spot.place.position[0], spot.place.position[2], 1.6, 1.6, colour, 0.95f);
    }
}

}  // namespace scenes::hundred
