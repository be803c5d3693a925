#include "samples/scenes/walkers/ground.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/stone.h"

namespace scenes::walkers
{

namespace
{

constexpr Rgb stone = {0.93f, 0.91f, 0.87f}, wall = {0.80f, 0.76f, 0.70f}, grass = {0.44f, 0.50f, 0.36f};
constexpr double margin_m = 4, half_thick_m = 0.1, country_m = 2000;

struct DestroyArea {
    void operator()(clq_area *p) const { clq_area_destroy(p); }
};

Vec3 at(double x, double y, double z) { return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}; }

uint32_t add_paving(Geometry &out, double x, double y, double z, Rgb colour)
{
    return out.add(at(x, y, z), {0, 1, 0}, static_cast<float>(x / double(flagstone_metres)),
                   static_cast<float>(z / double(flagstone_metres)), colour);
}

// A rectangle round the people that faces up, in pieces, so that lights on it are right near the eye.
void plate(Geometry &out, const Plan &plan, double half_x, double half_z, double y, Rgb colour, int pieces)
{
    std::vector<uint32_t> corners;
    for (int row = 0; row <= pieces; ++row)
        for (int column = 0; column <= pieces; ++column)
            corners.push_back(add_paving(out, plan.middle_x + half_x * (2.0 * column / pieces - 1), plan.ground + y,
                                         plan.middle_z + half_z * (2.0 * row / pieces - 1), colour));
    const auto corner = [&](int row, int column) { return corners[size_t(row * (pieces + 1) + column)]; };
    for (int row = 0; row < pieces; ++row)
        for (int column = 0; column < pieces; ++column) {
            out.triangle(corner(row, column), corner(row + 1, column), corner(row + 1, column + 1));
            out.triangle(corner(row, column), corner(row + 1, column + 1), corner(row, column + 1));
        }
}

// As long as its line and its thickness, so that corners are closed.
void raise_wall(Geometry &out, const double a[3], const double b[3], double wall_m)
{
    const double x = b[0] - a[0], z = b[2] - a[2], length = std::sqrt(x * x + z * z);
    if (!(length > 0)) return;
    const double x1 = x / length * half_thick_m, z1 = z / length * half_thick_m;
    const Vec3 low[4] = {at(a[0] - x1 - z1, a[1], a[2] - z1 + x1), at(b[0] + x1 - z1, b[1], b[2] + z1 + x1),
                         at(b[0] + x1 + z1, b[1], b[2] + z1 - x1), at(a[0] - x1 + z1, a[1], a[2] - z1 - x1)};
    Vec3 high[4];
    for (int i = 0; i < 4; ++i) high[i] = {low[i].x, low[i].y + static_cast<float>(wall_m), low[i].z};
    for (int i = 0; i < 4; ++i) {
        const int next = (i + 1) % 4;
        out.quad({low[i], low[next], high[next], high[i]}, wall);
    }
    out.quad({high[0], high[1], high[2], high[3]}, wall);
}

void pave(const clq_area_info &info, const Plan &plan, Rgb paving, double walls_m, Ground &ground)
{
    std::vector<double> points(3 * size_t(info.point_count));
    for (uint32_t i = 0; i < info.point_count; ++i) {
        const double *p = info.points_m + 3 * size_t(i);
        plan.to_scene(p[0], p[1], p[2], points.data() + 3 * size_t(i));
    }
    for (uint32_t t = 0; t < info.triangle_count; ++t) {
        uint32_t corners[3];
        for (int k = 0; k < 3; ++k) {
            const double *p = points.data() + 3 * size_t(info.triangles[3 * t + static_cast<uint32_t>(k)]);
            corners[k] = add_paving(ground.paving, p[0], p[1], p[2], paving);
        }
        ground.paving.triangle(corners[0], corners[1], corners[2]);
    }
    for (uint32_t w = 0; walls_m > 0 && w < info.wall_count; ++w)
        raise_wall(ground.walls, points.data() + 3 * size_t(info.walls[2 * w]),
                   points.data() + 3 * size_t(info.walls[2 * w + 1]), walls_m);
}

}  // namespace

void lay(Library &library, const Options &options, const Plan &plan, Ground &ground)
{
    const Rgb paving = options.paving.value_or(stone);
    plate(ground.around, plan, country_m, country_m, -0.05, options.around.value_or(grass), 40);
    if (options.area.empty()) {
        plate(ground.paving, plan, plan.half_x + margin_m, plan.half_z + margin_m, 0, paving, 16);
        return;
    }
    clq_area *made = nullptr;
    check(clq_area_load(library.context(), options.area.c_str(), &made), options.area);
    const std::unique_ptr<clq_area, DestroyArea> area(made);
    clq_area_info info = clq_area_info_init();
    check(clq_area_get_info(area.get(), &info));
    pave(info, plan, paving, options.walls_m, ground);
}

}  // namespace scenes::walkers
