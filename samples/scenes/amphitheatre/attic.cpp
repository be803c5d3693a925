// The gallery behind the last row with its columns, the attic above it, the masts, and the front outside.
#include "samples/scenes/amphitheatre/surround.h"
#include "samples/scenes/angles.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr Rgb stucco = {0.93f, 0.84f, 0.70f}, marble = {1.0f, 0.97f, 0.91f}, tile = {0.74f, 0.43f, 0.28f},
              travertine = {0.97f, 0.90f, 0.78f}, red_stucco = {0.70f, 0.33f, 0.25f}, timber = {0.45f, 0.32f, 0.22f},
              front_stone = {1.0f, 0.93f, 0.79f};
constexpr double step_m = 3.4;
constexpr double roof_thick_m = 0.55, attic_in_m = 50.6, mast_out_m = 51.6, mast_top_m = 55.6;

}  // namespace

void build_gallery(Masonry &m, const Plan &plan)
{
    const Walkway &way = plan.walkways()[tier_count - 1];
    const double back = attic_in_m - 0.4, roof = way.wall_top_m;
    m.sweep({{way.to_m - 0.1, way.level_m, 0.7}, {back, way.level_m, 0.45}}, 0, two_pi, step_m, stucco * 0.8f);
    m.sweep_shaded({{back, way.level_m, 0.6}, {back, way.level_m + 1.6, 0.75}}, 0, two_pi, step_m, red_stucco);
    m.sweep_shaded({{back, way.level_m + 1.6, 0.75}, {back, roof, 0.5}}, 0, two_pi, step_m, stucco);
    const double edge = way.from_m + 0.1;
    m.sweep_shaded({{back, roof, 0.25}, {edge, roof, 0.45}}, 0, two_pi, step_m, stucco);
    m.sweep({{edge, roof, 0.8}, {edge - 0.12, roof + 0.2, 0.9}, {edge - 0.12, roof + roof_thick_m, 1}}, 0, two_pi,
            step_m, marble);
    m.sweep({{edge - 0.12, roof + roof_thick_m, 1}, {attic_in_m, roof + roof_thick_m + 0.9, 0.8}}, 0, two_pi, step_m,
            tile);
    m.sweep({{attic_in_m, roof + roof_thick_m + 0.9, 0.8},
             {attic_in_m, height_m - 0.4, 1},
             {attic_in_m - 0.2, height_m - 0.3, 1},
             {attic_in_m - 0.2, height_m, 1},
             {building_m + 0.25, height_m, 1}},
            0, two_pi, step_m, travertine);
    for (int k = 0; k < 2 * bay_count; ++k) {
        const double turn = plan.turn_of(k / 2.0 + 0.25);
        m.column(turn, way.from_m + 0.42, way.level_m, roof, 0.27, 6, k % 2 == 0 ? marble : marble * 0.92f);
        m.block(turn, 0.36, way.from_m + 0.1, way.from_m + 0.74, roof - 0.4, roof, marble);
    }
}

void build_masts(Masonry &m, const Plan &plan)
{
    for (int k = 0; k < 3 * bay_count; ++k)
        m.block(plan.turn_of(k / 3.0), 0.14, mast_out_m, mast_out_m + 0.28, height_m - 0.2, mast_top_m, timber);
}

Geometry outer_wall(const Plan &plan, const Exposure &exposure)
{
    Geometry wall;
    uint32_t before[2] = {0, 0};
    for (int k = 0; k <= 2 * bay_count; ++k) {
        const double turn = plan.turn_of(k / 2.0 - 0.5);
        const Spot spot = plan.oval().at(turn, building_m);
        const Vec3 normal = {static_cast<float>(spot.out_x), 0, static_cast<float>(spot.out_z)};
        uint32_t now[2];
        for (int up = 0; up < 2; ++up) {
            const Vec3 at = {static_cast<float>(spot.x), static_cast<float>(up * height_m), static_cast<float>(spot.z)};
            now[up] = wall.add(at, normal, static_cast<float>(k) / 4, static_cast<float>(up),
                               front_stone * exposure.on(at, normal, up * 0.3 + 0.65));
        }
        if (k > 0) {
            wall.triangle(now[0], before[0], before[1]);
            wall.triangle(now[0], before[1], now[1]);
        }
        before[0] = now[0], before[1] = now[1];
    }
    return wall;
}

}  // namespace scenes::amphitheatre
