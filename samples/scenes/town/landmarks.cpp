#include "samples/scenes/town/landmarks.h"

#include "samples/scenes/town/roofs.h"
#include "samples/scenes/town/wall_builder.h"

namespace scenes::town
{
namespace
{

constexpr Rgb sandstone = {0.96f, 0.90f, 0.78f}, slate = {0.48f, 0.52f, 0.58f}, copper = {0.46f, 0.66f, 0.58f};
constexpr Rgb red_tile = {0.80f, 0.42f, 0.30f}, ochre = {0.97f, 0.84f, 0.60f}, gold = {0.90f, 0.74f, 0.36f};
constexpr Rgb limestone = {0.90f, 0.87f, 0.80f};

void church(Pieces &pieces, SunShadows &shadows, const Terrain &terrain, const Site &site)
{
    WallBuilder m(pieces, terrain, site);
    const WallBuilder::Room nave = {-6.5, 6.5, -15, 11}, choir = {-4, 4, -21, -15}, tower = {6.2, 13.2, 4.5, 11.5};
    const double y = m.floor({-6.5, 13.2, -21, 11});
    m.walls(nave, y, {3.2, 5.2}, sandstone, [](int side, int storey, int bay, int bays) {
        if (side == 0)
            return storey == 0 && bay == bays / 2   ? Bay::portal
                   : storey == 1 && bay == bays / 2 ? Bay::arch
                                                    : Bay::ashlar;
        return storey == 1 && side != 2 && bay % 2 == 1 ? Bay::arch : Bay::ashlar;
    });
    const RoofShape roof = {13.0, 6.5, y + 8.7, 1.15, 0.4};
    const Site ridge(site.ground(0, -2), site.along());
    for (const RoofPart part : {RoofPart::tiles, RoofPart::edges})
        gable_roof(pieces.on(SurfaceKind::tiles), ridge, roof, part, slate);
    gable_walls(pieces.on(SurfaceKind::facades), ridge, roof, sandstone, Bay::ashlar);
    m.walls(choir, y, {2.4, 3.6}, sandstone,
            [](int, int storey, int bay, int) { return storey == 1 && bay % 2 == 0 ? Bay::arch : Bay::ashlar; });
    hip_roof(pieces.on(SurfaceKind::tiles), Site(site.ground(0, -17.4), site.along()), {3.6, 4, y + 6.3, 1.0, 0.35},
             RoofPart::tiles, slate);
    for (const double side : {-1.0, 1.0})  // buttresses
        for (int i = 0; i < 4; ++i) {
            const double o = -12.5 + 6.0 * i, a = side * 6.5;
            if (side > 0 && o > 3) continue;
            m.box(std::min(a, a + side * 1.0), m.ground(a, o) - 0.03, o - 0.45, std::max(a, a + side * 1.0), y + 6.4,
                  o + 0.45, sandstone * 0.92f);
        }
    m.walls(tower, y, {3.2, 5.2, 5.0, 5.0, 4.6, 4.0}, sandstone * 0.97f, [](int side, int storey, int bay, int) {
        if (storey == 5) return Bay::arch;
        return storey == 0 && side == 0 && bay == 0 ? Bay::door : storey == 2 ? Bay::arch : Bay::ashlar;
    });
    for (const double out : {11.54, 4.46}) {  // clocks on its four sides
        const double left = out > 8 ? -1.6 : 1.6;
        Geometry &g = pieces.on(SurfaceKind::facades);
        site.bay(g, {9.7 + left, out, 9.7 - left, out}, y + 19.2, y + 19.2, y + 22.4, Bay::clock, sandstone);
        const double along = out > 8 ? 13.24 : 6.16;
        site.bay(g, {along, 8 - left, along, 8 + left}, y + 19.2, y + 19.2, y + 22.4, Bay::clock, sandstone);
    }
    const double top = y + 27.3;
    for (const double band : {8.7, 18.7, 27.0})
        m.box(5.95, y + band - 0.15, 4.25, 13.45, y + band + 0.25, 11.75, limestone);
    m.spire(9.7, 8, 3.5, top + 0.2, top + 15.5, copper);
    m.box(9.62, top + 15.0, 7.92, 9.78, top + 17.4, 8.08, gold);
    m.box(9.2, top + 16.4, 7.92, 10.2, top + 16.6, 8.08, gold);
    pieces.finish(Piece::Kind::landmark);
    throw_box(shadows, site, tower, y, top, top + 15);
    shadows.cast({site.at(-6.5, y, -15), site.at(6.5, y, -15), site.at(-6.5, y, 11), site.at(6.5, y, 11),
                  site.at(-6.5, y + 8.7, -15), site.at(6.5, y + 8.7, -15), site.at(-6.5, y + 8.7, 11),
                  site.at(6.5, y + 8.7, 11), site.at(0, roof.ridge(), 11), site.at(0, roof.ridge(), -15)},
                 y);
    throw_box(shadows, site, choir, y, y + 6.3, y + 10);
}

void town_hall(Pieces &pieces, SunShadows &shadows, const Terrain &terrain, const Site &site)
{
    WallBuilder m(pieces, terrain, site);
    const WallBuilder::Room house = {-13.5, 13.5, -6, 6}, turret = {-1.7, 1.7, -1.7, 1.7};
    const double y = m.floor(house);
    m.walls(house, y, {3.4, 3.2, 3.0}, ochre, [](int side, int storey, int bay, int bays) {
        if (storey == 0) return side == 0 && bay == bays / 2 ? Bay::portal : Bay::arch;
        return side == 0 ? (storey == 1 ? Bay::flowers : Bay::window) : Bay::window;
    });
    for (const double band : {3.7, 6.9}) m.box(-13.65, y + band - 0.1, -6.15, 13.65, y + band + 0.12, 6.15, limestone);
    for (const RoofPart part : {RoofPart::tiles, RoofPart::edges})
        hip_roof(pieces.on(SurfaceKind::tiles), site, {13.5, 6, y + 9.9, 0.75, 0.55}, part, red_tile);
    m.walls(turret, y + 12.6, {1.4, 3.0}, ochre,
            [](int, int storey, int, int) { return storey == 1 ? Bay::clock : Bay::blank; });
    m.spire(0, 0, 1.7, y + 17.3, y + 22.5, copper);
    m.box(-2.2, y + 3.9, 6.0, 2.2, y + 4.05, 7.3, limestone);  // a balcony
    for (const double x : {-2.2, 2.08}) m.box(x, y + 4.05, 6.0, x + 0.12, y + 4.95, 7.3, limestone);
    m.box(-2.2, y + 4.05, 7.18, 2.2, y + 4.95, 7.3, limestone);
    pieces.finish(Piece::Kind::landmark);
    throw_box(shadows, site, {-14, 14, -6.5, 6.5}, y, y + 9.6, y + 14.4);
    throw_box(shadows, site, turret, y, y + 17.3, y + 22);
}

}  // namespace

SquarePlan square_plan(const Plan &plan)
{
    const Block &b = plan.square();
    const double u = (b.u0 + b.u1) / 2;
    return {u - 22, b.v0 + 22, u + 22, b.v0 + 9, u, b.v0 + 55};
}

void build_landmarks(Pieces &pieces, SunShadows &shadows, const Plan &plan, const Terrain &terrain, uint64_t seed)
{
    const SquarePlan s = square_plan(plan);
    const auto site = [&](double u, double v, double turn) {
        const Point east = plan.east(u, v), out = {-east.z, east.x};
        return Site(plan.at(u, v), turn > 0 ? out : Point{-out.x, -out.z});
    };
    church(pieces, shadows, terrain, site(s.church_u, s.church_v, 1));
    town_hall(pieces, shadows, terrain, site(s.hall_u, s.hall_v, 1));
    build_fountain(pieces, shadows, terrain, plan.at(s.fountain_u, s.fountain_v));
    for (uint64_t i = 0; i < 8; ++i) {
        const double u = s.fountain_u + 8.0 + 5.2 * static_cast<double>(i % 4), v = s.fountain_v + (i < 4 ? -9 : 1.5);
        build_stall(pieces, shadows, terrain, site(u, v, i < 4 ? 1 : -1), seed, i);
    }
    build_bridge(pieces, plan, terrain);
}

}  // namespace scenes::town
