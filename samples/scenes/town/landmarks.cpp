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

// On the square; front 1: to the south, -1: to the north.
Site site_on(const Plan &plan, double u, double v, double front)
{
    const Point east = plan.east(u, v), out = {-east.z, east.x};
    return Site(plan.at(u, v), front > 0 ? out : Point{-out.x, -out.z});
}

}  // namespace

SquarePlan square_plan(const Plan &plan)
{
    const Block &b = plan.square();
    const double u = (b.u0 + b.u1) / 2;
    return {u - 22, b.v0 + 22, u + 22, b.v0 + 9, u, b.v0 + 55};
}

std::vector<Site> stall_sites(const Plan &plan, Trade trade)
{
    constexpr double first_u = 8.0, gap_u = 5.2, edge_m = 3;
    struct Row {
        double v, front;  // from the fountain; front 1: to the south
    };
    constexpr Row rows[] = {{-9, 1}, {1.5, -1}, {4.7, 1}, {15.2, -1}};
    const SquarePlan s = square_plan(plan);
    std::vector<Site> sites;
    const auto add = [&](double u, const Row &row) {
        if (s.fountain_v + row.v + edge_m > plan.square().v1) return;
        sites.push_back(site_on(plan, u, s.fountain_v + row.v, row.front));
    };
    for (const Row &row : {rows[0], rows[1]})
        for (int i = 0; i < 4; ++i) add(s.fountain_u + first_u + gap_u * i, row);
    if (trade == Trade::ordinary) return sites;
    for (const Row &row : {rows[2], rows[3]})
        for (int i = 0; i < 4; ++i) add(s.fountain_u + first_u + gap_u * i, row);
    for (const Row &row : rows)
        for (int i = 0; i < 4; ++i) add(s.fountain_u - first_u - gap_u * i, row);
    return sites;
}

std::vector<Footprint> landmark_footprints(const Plan &plan, Trade trade)
{
    const SquarePlan s = square_plan(plan);
    const Site church_site = site_on(plan, s.church_u, s.church_v, 1), hall = site_on(plan, s.hall_u, s.hall_v, 1);
    std::vector<Footprint> all = {{church_site, -6.5, 6.5, -15, 11},
                                  {church_site, -4, 4, -21, -15},
                                  {church_site, 6.2, 13.2, 4.5, 11.5},
                                  {church_site, -7.5, 7.5, -13, 6},
                                  {hall, -13.65, 13.65, -6.15, 6.15}};
    for (const Site &stall : stall_sites(plan, trade)) {
        all.push_back({stall, -1.55, 1.55, 0.1, 0.97});
        for (const double along : {-1.5, 1.5}) all.push_back({stall, along - 0.06, along + 0.06, -0.97, -0.83});
    }
    return all;
}

std::vector<Footprint> stall_booths(const Plan &plan, Trade trade)
{
    std::vector<Footprint> all;
    for (const Site &stall : stall_sites(plan, trade)) all.push_back({stall, -1.6, 1.6, -1.05, 0.15});
    return all;
}

void build_landmarks(Pieces &pieces, SunShadows &shadows, const Plan &plan, const Terrain &terrain, uint64_t seed,
                     Trade trade)
{
    const SquarePlan s = square_plan(plan);
    church(pieces, shadows, terrain, site_on(plan, s.church_u, s.church_v, 1));
    town_hall(pieces, shadows, terrain, site_on(plan, s.hall_u, s.hall_v, 1));
    build_fountain(pieces, shadows, terrain, plan.at(s.fountain_u, s.fountain_v));
    uint64_t number = 0;
    for (const Site &site : stall_sites(plan, trade)) build_stall(pieces, shadows, terrain, site, seed, number++);
    build_bridge(pieces, plan, terrain);
}

}  // namespace scenes::town
