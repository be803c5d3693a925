#include "samples/scenes/town/landmarks.h"

#include "samples/scenes/lot.h"
#include "samples/scenes/town/roofs.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace scenes::town
{
namespace
{

constexpr Rgb sandstone = {0.96f, 0.90f, 0.78f}, slate = {0.48f, 0.52f, 0.58f}, copper = {0.46f, 0.66f, 0.58f};
constexpr Rgb red_tile = {0.80f, 0.42f, 0.30f}, ochre = {0.97f, 0.84f, 0.60f}, gold = {0.90f, 0.74f, 0.36f};
constexpr Rgb limestone = {0.90f, 0.87f, 0.80f}, pool = {0.52f, 0.68f, 0.72f};

Vec3 point(double along, double y, double out)
{
    return {static_cast<float>(along), static_cast<float>(y), static_cast<float>(out)};
}

class Mason
{
public:
    Mason(Pieces &pieces, const Terrain &terrain, const Site &site) : pieces_(pieces), terrain_(terrain), site_(site) {}

    double ground(double along, double out) const
    {
        const Point p = site_.ground(along, out);
        return terrain_.height(p.x, p.z);
    }

    struct Room {
        double a0, a1, o0, o1;
    };
    double floor(const Room &r) const
    {
        return std::max({ground(r.a0, r.o0), ground(r.a1, r.o0), ground(r.a0, r.o1), ground(r.a1, r.o1)});
    }

    // Four walls from the ground up, a plinth, then storeys; which bay is where is asked by (side, storey, bay, of).
    using Choice = std::function<Bay(int side, int storey, int bay, int bays)>;
    void walls(const Room &r, double floor_y, const std::vector<double> &storeys_m, Rgb colour, const Choice &choose)
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
                Geometry &g = pieces_.on(Layer::facades);
                double low = floor_y + 0.3;
                site_.bay(g, part, std::min(low, ground(part.left_along, part.left_out)) - 0.03,
                          std::min(low, ground(part.right_along, part.right_out)) - 0.03, low, Bay::plinth,
                          colour * 0.94f, 3);
                for (size_t storey = 0; storey < storeys_m.size(); ++storey) {
                    const double high = low + storeys_m[storey];
                    site_.bay(g, part, low, low, high, choose(side, static_cast<int>(storey), bay, bays), colour);
                    low = high;
                }
            }
        }
    }

    void box(double a0, double y0, double o0, double a1, double y1, double o1, Rgb colour)
    {
        site_.box(pieces_.on(Layer::stone), point(a0, y0, o0), point(a1, y1, o1), colour, 4);
    }

    // A steep roof of four sides over a square tower, bent outwards at the eaves.
    void spire(double a, double o, double half, double low, double high, Rgb colour)
    {
        Geometry &g = pieces_.on(Layer::tiles);
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

    Pieces &pieces_;
    const Terrain &terrain_;
    Site site_;
};

void throw_box(SunShadows &shadows, const Site &site, const Mason::Room &r, double low, double high, double peak)
{
    std::vector<Vec3> points;
    for (const double a : {r.a0, r.a1})
        for (const double o : {r.o0, r.o1})
            for (const double y : {low, high}) points.push_back(site.at(a, y, o));
    if (peak > high) points.push_back(site.at((r.a0 + r.a1) / 2, peak, (r.o0 + r.o1) / 2));
    shadows.cast(points, low);
}

void church(Pieces &pieces, SunShadows &shadows, const Terrain &terrain, const Site &site)
{
    Mason m(pieces, terrain, site);
    const Mason::Room nave = {-6.5, 6.5, -15, 11}, choir = {-4, 4, -21, -15}, tower = {6.2, 13.2, 4.5, 11.5};
    const double y = m.floor({-6.5, 13.2, -21, 11});
    m.walls(nave, y, {3.2, 5.2}, sandstone, [](int side, int storey, int bay, int bays) {
        if (side == 0)
            return storey == 0 && bay == bays / 2   ? Bay::portal
                   : storey == 1 && bay == bays / 2 ? Bay::clock
                                                    : Bay::ashlar;
        return storey == 1 && side != 2 && bay % 2 == 1 ? Bay::arch : Bay::ashlar;
    });
    const RoofShape roof = {13.0, 6.5, y + 8.7, 1.15, 0.4};
    const Site ridge(site.ground(0, -2), site.along());
    for (const RoofPart part : {RoofPart::tiles, RoofPart::edges})
        gable_roof(pieces.on(Layer::tiles), ridge, roof, part, slate);
    gable_walls(pieces.on(Layer::facades), ridge, roof, sandstone, Bay::ashlar);
    m.walls(choir, y, {2.4, 3.6}, sandstone,
            [](int, int storey, int bay, int) { return storey == 1 && bay % 2 == 0 ? Bay::arch : Bay::ashlar; });
    hip_roof(pieces.on(Layer::tiles), Site(site.ground(0, -17.4), site.along()), {3.6, 4, y + 6.3, 1.0, 0.35},
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
        if (storey == 4) return Bay::clock;
        return storey == 0 && side == 0 && bay == 0 ? Bay::door : storey == 2 ? Bay::arch : Bay::ashlar;
    });
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
    Mason m(pieces, terrain, site);
    const Mason::Room house = {-13.5, 13.5, -6, 6}, turret = {-1.7, 1.7, -1.7, 1.7};
    const double y = m.floor(house);
    m.walls(house, y, {3.4, 3.2, 3.0}, ochre, [](int side, int storey, int bay, int bays) {
        if (storey == 0) return side == 0 && bay == bays / 2 ? Bay::portal : Bay::arch;
        return side == 0 ? (storey == 1 ? Bay::flowers : Bay::window) : Bay::window;
    });
    for (const double band : {3.7, 6.9}) m.box(-13.65, y + band - 0.1, -6.15, 13.65, y + band + 0.12, 6.15, limestone);
    for (const RoofPart part : {RoofPart::tiles, RoofPart::edges})
        hip_roof(pieces.on(Layer::tiles), site, {13.5, 6, y + 9.9, 0.75, 0.55}, part, red_tile);
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

void fountain(Pieces &pieces, SunShadows &shadows, const Terrain &terrain, Point at)
{
    const float x = static_cast<float>(at.x), z = static_cast<float>(at.z),
                y = static_cast<float>(terrain.height(at.x, at.z));
    Geometry &g = pieces.on(Layer::stone);
    g.turned(x, z, {{3.9f, y - 0.03f}, {3.9f, y + 0.18f}}, 20, limestone);
    g.disc(x, y + 0.18f, z, 3.9f, 20, limestone);
    g.turned(x, z, {{3.3f, y + 0.18f}, {3.2f, y + 0.62f}, {3.4f, y + 0.78f}}, 20, limestone);
    g.disc(x, y + 0.78f, z, 3.4f, 20, limestone);
    pieces.on(Layer::water).disc(x, y + 0.80f, z, 3.05f, 20, pool);
    g.turned(x, z, {{0.5f, y + 0.7f}, {0.3f, y + 1.1f}, {0.26f, y + 1.7f}, {1.1f, y + 2.15f}, {1.15f, y + 2.25f}}, 14,
             limestone);
    pieces.on(Layer::water).disc(x, y + 2.25f, z, 1.12f, 14, pool);
    g.turned(x, z, {{0.2f, y + 2.2f}, {0.12f, y + 3.0f}, {0.24f, y + 3.2f}, {0.0f, y + 3.7f}}, 10, limestone);
    pieces.finish(Piece::Kind::landmark);
    throw_box(shadows, Site(at, {0, 1}), {-3.2, 3.2, -3.2, 3.2}, y, y + 0.78, y + 3);
}

// A table under a striped awning on four poles.
void stall(Pieces &pieces, SunShadows &shadows, const Terrain &terrain, const Site &site, uint64_t seed, uint64_t who)
{
    constexpr Rgb dyes[] = {{0.86f, 0.26f, 0.22f}, {0.26f, 0.46f, 0.72f}, {0.92f, 0.70f, 0.24f}, {0.32f, 0.60f, 0.38f}};
    constexpr Rgb goods[] = {{0.90f, 0.52f, 0.16f},
                             {0.76f, 0.20f, 0.16f},
                             {0.56f, 0.70f, 0.26f},
                             {0.86f, 0.76f, 0.40f},
                             {0.50f, 0.24f, 0.42f}};
    Mason m(pieces, terrain, site);
    const double y = m.ground(0, 0);
    const Rgb dye = dyes[who % 4], white = {0.97f, 0.96f, 0.92f}, wood = {0.62f, 0.47f, 0.33f};
    for (const double a : {-1.5, 1.5})
        for (const double o : {-0.9, 0.9})
            m.box(a - 0.05, m.ground(a, o) - 0.03, o - 0.05, a + 0.05, y + 2.3, o + 0.05, wood);
    m.box(-1.4, m.ground(0, 0.5) - 0.03, 0.15, 1.4, y + 0.88, 0.85, wood);
    for (int i = 0; i < 6; ++i) {
        const double a = -1.3 + 0.44 * i;
        const float tone =
            static_cast<float>(lot_between(seed, who * 8 + static_cast<uint64_t>(i), Lot::tone, 0.85, 1.1));
        m.box(a, y + 0.85, 0.22, a + 0.38, y + 0.98, 0.80, goods[(who + static_cast<uint64_t>(i) * 3) % 5] * tone);
    }
    Geometry &g = pieces.on(Layer::stone);
    for (int i = 0; i < 8; ++i) {
        const double a0 = -1.75 + 3.5 * i / 8, a1 = -1.75 + 3.5 * (i + 1) / 8;
        const Rgb colour = i % 2 == 0 ? dye : white;
        site.face(g,
                  {point(a0, y + 2.15, 1.25), point(a1, y + 2.15, 1.25), point(a1, y + 2.65, -1.15),
                   point(a0, y + 2.65, -1.15)},
                  colour, 4);
        site.face(g,
                  {point(a0, y + 2.15, 1.25), point(a0, y + 2.65, -1.15), point(a1, y + 2.65, -1.15),
                   point(a1, y + 2.15, 1.25)},
                  colour * 0.6f, 4);
        site.face(g,
                  {point(a0, y + 1.93, 1.27), point(a1, y + 1.93, 1.27), point(a1, y + 2.15, 1.25),
                   point(a0, y + 2.15, 1.25)},
                  colour, 4);
    }
    pieces.finish(Piece::Kind::landmark);
    throw_box(shadows, site, {-1.75, 1.75, -1.15, 1.25}, y, y + 2.4, 0);
}

// Parapets over the embankments of the high street, and the vault for the water under them.
void bridge(Pieces &pieces, const Plan &plan, const Terrain &terrain)
{
    const double half = Plan::half_v(Plan::high_street), v = plan.streets_v()[Plan::high_street], u = plan.stream_u();
    for (const double side : {-1.0, 1.0}) {
        const Point out = plan.south(u, v), at = plan.at(u, v + side * half);
        const Site site(at, {side * out.x, side * out.z});
        Mason m(pieces, terrain, site);
        const double road = m.ground(0, -0.3), wet = m.ground(0, 2.5);
        m.box(-13, std::min(m.ground(-13, -0.2), m.ground(13, -0.2)) - 0.03, -0.4, 13, road + 0.95, 0.05,
              limestone * 0.86f);
        m.box(-4.6, wet - 0.03, 0.02, 4.6, road + 0.95, 1.0, limestone * 0.86f);
        m.box(-13.2, road + 0.95, -0.5, 13.2, road + 1.1, 0.15, limestone);
        m.box(-4.8, road + 0.95, -0.1, 4.8, road + 1.1, 1.1, limestone);
        Geometry &g = pieces.on(Layer::stone);
        const double rise = road - wet - 0.25;
        for (int i = 0; i < 10; ++i) {  // the mouth, dark, and its ring of stones
            const auto arch = [&](int k, double grown, double lift) {
                const double t = 3.141592653589793 * k / 10;
                return point((-3.0 - grown) * std::cos(t), wet + (rise + grown) * std::sin(t), 1.0 + lift);
            };
            site.face(g, {point(0, wet, 1.03), arch(i + 1, 0, 0.03), arch(i, 0, 0.03)}, {0.20f, 0.21f, 0.22f}, 4);
            site.face(g, {arch(i, 0, 0.06), arch(i + 1, 0, 0.06), arch(i + 1, 0.28, 0.06), arch(i, 0.28, 0.06)},
                      limestone * (i % 2 == 0 ? 0.95f : 0.82f), 4);
        }
        pieces.finish(Piece::Kind::landmark);
    }
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
    fountain(pieces, shadows, terrain, plan.at(s.fountain_u, s.fountain_v));
    for (uint64_t i = 0; i < 8; ++i) {
        const double u = s.fountain_u + 8.0 + 5.2 * static_cast<double>(i % 4), v = s.fountain_v + (i < 4 ? -9 : 1.5);
        stall(pieces, shadows, terrain, site(u, v, i < 4 ? 1 : -1), seed, i);
    }
    bridge(pieces, plan, terrain);
}

}  // namespace scenes::town
