#include "samples/scenes/amphitheatre/awning.h"

#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/random.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr double gap_bays = 0.05;  // on each side of a strip
constexpr double belly_m = 0.55;   // of the cloth between its ropes
constexpr uint32_t across = 5, along = 14;

float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vec3 place(const Plan &plan, double turn, double out, double y)
{
    const Spot spot = plan.oval().at(turn, out);
    return {static_cast<float>(spot.x), static_cast<float>(y), static_cast<float>(spot.z)};
}

// The light of the cloth's upper or lower side.
Rgb lit(Rgb dye, const Daylight &light, Vec3 normal, bool above)
{
    const float sun = std::fabs(dot(normal, light.to_sun)) * (above ? 0.95f : 0.55f);
    const float sky = above ? 1.0f : 0.45f;
    return {dye.r * (light.sun.r * sun + light.sky.r * sky + 0.06f),
            dye.g * (light.sun.g * sun + light.sky.g * sky + 0.05f),
            dye.b * (light.sun.b * sun + light.sky.b * sky + 0.04f)};
}

void strip(Geometry &cloth, const Plan &plan, const Velarium &velarium, const Daylight &light, int bay, uint64_t seed)
{
    const double reach = velarium.reach_of(bay);
    const Rgb dye = Velarium::dye_of(bay);
    for (const bool above : {true, false}) {
        const uint32_t first = static_cast<uint32_t>(cloth.vertices().size());
        for (uint32_t step = 0; step <= along; ++step)
            for (uint32_t k = 0; k <= across; ++k) {
                const double side = static_cast<double>(k) / across * 2 - 1;
                const double out = Velarium::mast_m - reach * step / along;
                const double turn = plan.turn_of(bay + side * (0.5 - gap_bays));
                // It hangs between its ropes, in folds that grow towards its free end.
                const double fold =
                    0.07 *
                    std::sin(step * 1.9 +
                             static_cast<double>(random_bits(seed, static_cast<uint64_t>(bay), Purpose::phase) % 7));
                const double y = velarium.height_at(out) - belly_m * (1 - side * side) + fold;
                const Spot spot = plan.oval().at(turn, out);
                // Leaning inwards with the ropes, and to the sides with the belly.
                const float lean = static_cast<float>(-0.10 * side * 2), fall = -0.16f + static_cast<float>(0.5 * fold);
                Vec3 n = {static_cast<float>(spot.out_x) * fall - static_cast<float>(-spot.out_z) * lean, 1,
                          static_cast<float>(spot.out_z) * fall - static_cast<float>(spot.out_x) * lean};
                const float length = std::sqrt(dot(n, n));
                n = {n.x / length, n.y / length, n.z / length};
                const float seam = k == 0 || k == across ? 0.86f : 1.0f;
                const float tone = seam * static_cast<float>(random_between(
                                              seed, static_cast<uint64_t>(bay) * 32 + step, Purpose::tone, 0.94, 1.04));
                cloth.add(place(plan, turn, out, y), n, static_cast<float>(k) / across * 1.1f,
                          static_cast<float>(step) / 3.0f, lit(dye, light, n, above) * tone);
            }
        for (uint32_t step = 0; step < along; ++step)
            for (uint32_t k = 0; k < across; ++k) {
                const uint32_t a = first + step * (across + 1) + k, b = a + across + 1;  // b further in
                if (above) cloth.triangle(b, b + 1, a + 1), cloth.triangle(b, a + 1, a);
                else cloth.triangle(b, a + 1, b + 1), cloth.triangle(b, a, a + 1);
            }
    }
}

}  // namespace

Geometry linen(const Plan &plan, const Velarium &velarium, const Daylight &light, uint64_t seed)
{
    Geometry cloth;
    for (int bay = 0; bay < bay_count; ++bay) strip(cloth, plan, velarium, light, bay, seed);
    return cloth;
}

Geometry ropes(const Plan &plan, const Velarium &velarium)
{
    constexpr Rgb hemp = {0.30f, 0.24f, 0.17f};
    constexpr float thick = 0.05f, faint = 0.5f;
    Geometry out;
    const auto piece = [&](Vec3 a, Vec3 b, Vec3 side) {
        const uint32_t first = out.add({a.x - side.x, a.y - side.y, a.z - side.z}, {0, 1, 0}, 0, 0, hemp, faint);
        out.add({a.x + side.x, a.y + side.y, a.z + side.z}, {0, 1, 0}, 0, 0, hemp, faint);
        out.add({b.x + side.x, b.y + side.y, b.z + side.z}, {0, 1, 0}, 0, 0, hemp, faint);
        out.add({b.x - side.x, b.y - side.y, b.z - side.z}, {0, 1, 0}, 0, 0, hemp, faint);
        out.triangle(first, first + 1, first + 2);
        out.triangle(first, first + 2, first + 3);
    };
    constexpr int pieces = 8;
    for (int bay = 0; bay < bay_count; ++bay) {
        const double turn = plan.turn_of(bay + 0.5);
        const Spot spot = plan.oval().at(turn, 0);
        const Vec3 side = {static_cast<float>(-spot.out_z) * thick, 0, static_cast<float>(spot.out_x) * thick};
        for (int k = 0; k < pieces; ++k) {
            const auto at = [&](int i) {
                const double distance = Velarium::mast_m + (Velarium::ring_m - Velarium::mast_m) * i / pieces;
                return place(plan, turn, distance, velarium.height_at(distance) + 0.05);
            };
            piece(at(k), at(k + 1), side);
            piece(at(k), at(k + 1), {0, thick, 0});
        }
    }
    for (int k = 0; k < 96; ++k) {
        const auto at = [&](int i) {
            return place(plan, two_pi * i / 96, Velarium::ring_m, velarium.height_at(Velarium::ring_m) + 0.05);
        };
        piece(at(k), at(k + 1), {0, 2 * thick, 0});
    }
    return out;
}

}  // namespace scenes::amphitheatre
