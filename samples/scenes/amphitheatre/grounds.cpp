#include "samples/scenes/amphitheatre/grounds.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/random.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr Rgb sand_colour = {0.90f, 0.79f, 0.60f}, stone = {0.76f, 0.71f, 0.62f}, country = {0.60f, 0.66f, 0.57f},
              roof_tile = {0.70f, 0.46f, 0.34f};
constexpr double paved_m = 22, land_m = 560;

Rgb mix(Rgb a, Rgb b, double share)
{
    const float t = static_cast<float>(share);
    return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
}

// Triangles between rings of so many columns, the first ring inside; faces up.
void rings(Geometry &out, uint32_t ring_count, uint32_t columns)
{
    for (uint32_t ring = 0; ring + 1 < ring_count; ++ring)
        for (uint32_t k = 0; k + 1 < columns; ++k) {
            const uint32_t a = ring * columns + k, b = a + columns;
            out.triangle(a, a + 1, b + 1);
            out.triangle(a, b + 1, b);
        }
}

class House
{
public:
    House(Geometry &out, const Daylight &light) : out_(out), light_(light) {}

    void build(double x, double z, double half_x, double half_z, double high, double ridge, Rgb wall, Rgb tiles)
    {
        const auto at = [&](double sx, double y, double sz) {
            return Vec3{static_cast<float>(x + sx * half_x), static_cast<float>(y),
                        static_cast<float>(z + sz * half_z)};
        };
        const Vec3 a = at(-1, 0, 1), b = at(1, 0, 1), c = at(1, 0, -1), d = at(-1, 0, -1);
        const auto up = [&](Vec3 p) { return Vec3{p.x, static_cast<float>(high), p.z}; };
        face({a, b, up(b), up(a)}, {0, 0, 1}, wall);
        face({b, c, up(c), up(b)}, {1, 0, 0}, wall);
        face({c, d, up(d), up(c)}, {0, 0, -1}, wall);
        face({d, a, up(a), up(d)}, {-1, 0, 0}, wall);
        const Vec3 left = at(-0.55, high + ridge, 0), right = at(0.55, high + ridge, 0);
        const float slope = static_cast<float>(half_z / std::sqrt(half_z * half_z + ridge * ridge));
        const float lean = std::sqrt(1 - slope * slope);
        face({up(a), up(b), right, left}, {0, slope, lean}, tiles);
        face({up(c), up(d), left, right}, {0, slope, -lean}, tiles);
        face({up(b), up(c), right, right}, {lean, slope, 0}, tiles);
        face({up(d), up(a), left, left}, {-lean, slope, 0}, tiles);
    }

private:
    void face(const std::array<Vec3, 4> &p, Vec3 n, Rgb colour)
    {
        const float sun = std::max(0.0f, n.x * light_.to_sun.x + n.y * light_.to_sun.y + n.z * light_.to_sun.z);
        const Rgb lit = {colour.r * (light_.sky.r + light_.bounce.r * 0.5f + light_.sun.r * sun),
                         colour.g * (light_.sky.g + light_.bounce.g * 0.5f + light_.sun.g * sun),
                         colour.b * (light_.sky.b + light_.bounce.b * 0.5f + light_.sun.b * sun)};
        uint32_t made[4];
        for (size_t k = 0; k < 4; ++k)
            made[k] = out_.add(p[k], n, p[k].x / 6 + p[k].z / 6, p[k].y / 6, lit * (p[k].y > 0 ? 1.0f : 0.75f));
        out_.triangle(made[0], made[1], made[2]);
        out_.triangle(made[0], made[2], made[3]);
    }

    Geometry &out_;
    const Daylight &light_;
};

}  // namespace

Geometry arena_floor(const Plan &plan, const Exposure &exposure)
{
    constexpr uint32_t ring_count = 26, columns = 129;
    Geometry floor;
    for (uint32_t ring = 0; ring < ring_count; ++ring)
        for (uint32_t k = 0; k < columns; ++k) {
            const Spot edge = plan.oval().at(two_pi * k / (columns - 1), 0.1);
            const double share = static_cast<double>(ring) / (ring_count - 1);
            const Vec3 at = {static_cast<float>(edge.x * share), 0, static_cast<float>(edge.z * share)};
            const double open = 0.93 - 0.25 * std::max(0.0, share - 0.9) / 0.1;
            floor.add(at, {0, 1, 0}, at.x / static_cast<float>(sand_metres), at.z / static_cast<float>(sand_metres),
                      sand_colour * exposure.on(at, {0, 1, 0}, open));
        }
    rings(floor, ring_count, columns);
    return floor;
}

Geometry paving(const Plan &plan, const Exposure &exposure)
{
    constexpr uint32_t ring_count = 9, columns = 97;
    constexpr double outs[ring_count] = {-0.3, 4, 9, paved_m, paved_m + 1, 60, 120, 250, land_m};
    Geometry ground;
    for (uint32_t ring = 0; ring < ring_count; ++ring)
        for (uint32_t k = 0; k < columns; ++k) {
            const Spot spot = plan.oval().at(two_pi * k / (columns - 1), building_m + outs[ring]);
            const Vec3 at = {static_cast<float>(spot.x), 0, static_cast<float>(spot.z)};
            const double far_away = std::clamp((outs[ring] - 60) / 400, 0.0, 1.0);
            const Rgb near = ring < 4 ? stone : Rgb{0.69f, 0.63f, 0.51f};
            ground.add(at, {0, 1, 0}, at.x / 8, at.z / 8,
                       mix(near * exposure.with(1, {0, 1, 0}, ring == 0 ? 0.6 : 1), country, far_away));
        }
    rings(ground, ring_count, columns);
    return ground;
}

Geometry houses(const Plan &plan, const Daylight &light, uint64_t seed)
{
    constexpr double block_m = 19;
    constexpr int reach = 18;
    Geometry out;
    House house(out, light);
    for (int row = -reach; row <= reach; ++row)
        for (int column = -reach; column <= reach; ++column) {
            const uint64_t person = static_cast<uint64_t>((row + reach) * 64 + column + reach);
            const double x = column * block_m + random_between(seed, person, Purpose::place_x, -2.5, 2.5),
                         z = row * block_m + random_between(seed, person, Purpose::place_z, -2.5, 2.5);
            const double away = plan.oval().bearing(x, z).out - building_m;
            if (away < paved_m + 14 || away > 235 || random_unit(seed, person, Purpose::tries) < 0.13) continue;
            const double grey = random_between(seed, person, Purpose::tone, 0.78, 1.0),
                         red = random_unit(seed, person, Purpose::grain);
            const Rgb wall = mix({0.95f, 0.86f, 0.70f}, {0.84f, 0.60f, 0.45f}, red) * static_cast<float>(grey);
            const double high = random_between(seed, person, Purpose::size, 5, 12.5);
            house.build(x, z, random_between(seed, person, Purpose::lane, 5.5, 8),
                        random_between(seed, person, Purpose::gap, 4.5, 7.2), high,
                        random_between(seed, person, Purpose::radius, 1.4, 2.4), wall,
                        roof_tile * static_cast<float>(random_between(seed, person, Purpose::slab, 0.8, 1.12)));
        }
    return out;
}

}  // namespace scenes::amphitheatre
