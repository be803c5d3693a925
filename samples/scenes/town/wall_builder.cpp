#include "samples/scenes/town/wall_builder.h"

#include <algorithm>
#include <cmath>

namespace scenes::town
{

double WallBuilder::ground(double along, double out) const
{
    const Point p = site_.ground(along, out);
    return terrain_.height(p.x, p.z);
}

double WallBuilder::floor(const Room &r) const
{
    return std::max({ground(r.a0, r.o0), ground(r.a1, r.o0), ground(r.a0, r.o1), ground(r.a1, r.o1)});
}

void WallBuilder::walls(const Room &r, double floor_y, const std::vector<double> &storeys_m, Rgb colour,
                        const Choice &choose)
{
    const Site::Upright sides[] = {
        {r.a0, r.o1, r.a1, r.o1}, {r.a1, r.o1, r.a1, r.o0}, {r.a1, r.o0, r.a0, r.o0}, {r.a0, r.o0, r.a0, r.o1}};
    for (int side = 0; side < 4; ++side) {
        const Site::Upright &w = sides[side];
        const double da = w.right_along - w.left_along, dout = w.right_out - w.left_out;
        const int bays = std::max(1, static_cast<int>(std::sqrt(da * da + dout * dout) / 3.0 + 0.5));
        for (int bay = 0; bay < bays; ++bay) {
            const double s = static_cast<double>(bay) / bays, t = static_cast<double>(bay + 1) / bays;
            const Site::Upright part = {w.left_along + da * s, w.left_out + dout * s, w.left_along + da * t,
                                        w.left_out + dout * t};
            Geometry &g = pieces_.on(SurfaceKind::facades);
            double low = floor_y + 0.3;
            site_.bay(g, part, std::min(low, ground(part.left_along, part.left_out)) - 0.03,
                      std::min(low, ground(part.right_along, part.right_out)) - 0.03, low, Bay::plinth, colour * 0.94f,
                      3);
            for (size_t storey = 0; storey < storeys_m.size(); ++storey) {
                const double high = low + storeys_m[storey];
                site_.bay(g, part, low, low, high, choose(side, static_cast<int>(storey), bay, bays), colour);
                low = high;
            }
        }
    }
}

void WallBuilder::box(double a0, double y0, double o0, double a1, double y1, double o1, Rgb colour)
{
    site_.box(pieces_.on(SurfaceKind::stone), point(a0, y0, o0), point(a1, y1, o1), colour, 4);
}

void WallBuilder::spire(double a, double o, double half, double low, double high, Rgb colour)
{
    Geometry &g = pieces_.on(SurfaceKind::tiles);
    const double waist = 0.62 * half, bend = low + 0.16 * (high - low), wide = half + 0.35;
    for (int side = 0; side < 4; ++side) {
        const double s = side == 1 ? 1 : side == 3 ? -1 : 0, c = side == 0 ? 1 : side == 2 ? -1 : 0;
        const auto at = [&](double left, double out, double y) {
            return point(a + s * out - c * -left, y, o + c * out - s * left);
        };
        site_.face(g, {at(-wide, wide, low), at(wide, wide, low), at(waist, waist, bend), at(-waist, waist, bend)},
                   colour, tiles_metres);
        site_.face(g, {at(-waist, waist, bend), at(waist, waist, bend), at(0, 0, high)}, colour, tiles_metres);
    }
}

void throw_box(SunShadows &shadows, const Site &site, const WallBuilder::Room &r, double low, double high, double peak)
{
    std::vector<Vec3> points;
    for (const double a : {r.a0, r.a1})
        for (const double o : {r.o0, r.o1})
            for (const double y : {low, high}) points.push_back(site.at(a, y, o));
    if (peak > high) points.push_back(site.at((r.a0 + r.a1) / 2, peak, (r.o0 + r.o1) / 2));
    shadows.cast(points, low);
}

}  // namespace scenes::town
