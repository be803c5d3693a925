// The fountain, the market stalls, and the bridge of the high street over the stream.
#include <algorithm>
#include <cmath>

#include "samples/scenes/random.h"
#include "samples/scenes/town/landmarks.h"
#include "samples/scenes/town/wall_builder.h"

namespace scenes::town
{
namespace
{

constexpr Rgb market_limestone = {0.90f, 0.87f, 0.80f}, pool = {0.52f, 0.68f, 0.72f};
constexpr auto market_point = WallBuilder::point;

}  // namespace

void build_fountain(Pieces &pieces, SunShadows &shadows, const Terrain &terrain, Point at)
{
    const float x = static_cast<float>(at.x), z = static_cast<float>(at.z),
                y = static_cast<float>(terrain.height(at.x, at.z));
    Geometry &g = pieces.on(SurfaceKind::stone);
    g.turned(x, z, {{3.9f, y - 0.03f}, {3.9f, y + 0.18f}}, 20, market_limestone);
    g.disc(x, y + 0.18f, z, 3.9f, 20, market_limestone);
    g.turned(x, z, {{3.3f, y + 0.18f}, {3.2f, y + 0.62f}, {3.4f, y + 0.78f}}, 20, market_limestone);
    g.disc(x, y + 0.78f, z, 3.4f, 20, market_limestone);
    pieces.on(SurfaceKind::water).disc(x, y + 0.80f, z, 3.05f, 20, pool);
    g.turned(x, z, {{0.5f, y + 0.7f}, {0.3f, y + 1.1f}, {0.26f, y + 1.7f}, {1.1f, y + 2.15f}, {1.15f, y + 2.25f}}, 14,
             market_limestone);
    pieces.on(SurfaceKind::water).disc(x, y + 2.25f, z, 1.12f, 14, pool);
    g.turned(x, z, {{0.2f, y + 2.2f}, {0.12f, y + 3.0f}, {0.24f, y + 3.2f}, {0.02f, y + 3.7f}}, 10, market_limestone);
    pieces.finish(Piece::Kind::landmark);
    throw_box(shadows, Site(at, {0, 1}), {-3.2, 3.2, -3.2, 3.2}, y, y + 0.78, y + 3);
}

// A table under a striped awning on four poles.
void build_stall(Pieces &pieces, SunShadows &shadows, const Terrain &terrain, const Site &site, uint64_t seed,
                 uint64_t number)
{
    constexpr Rgb dyes[] = {{0.86f, 0.26f, 0.22f}, {0.26f, 0.46f, 0.72f}, {0.92f, 0.70f, 0.24f}, {0.32f, 0.60f, 0.38f}};
    constexpr Rgb goods[] = {{0.90f, 0.52f, 0.16f},
                             {0.76f, 0.20f, 0.16f},
                             {0.56f, 0.70f, 0.26f},
                             {0.86f, 0.76f, 0.40f},
                             {0.50f, 0.24f, 0.42f}};
    WallBuilder m(pieces, terrain, site);
    const double y = m.ground(0, 0);
    const Rgb dye = dyes[number % 4], white = {0.97f, 0.96f, 0.92f}, wood = {0.62f, 0.47f, 0.33f};
    for (const double a : {-1.5, 1.5})
        for (const double o : {-0.9, 0.9})
            m.box(a - 0.05, m.ground(a, o) - 0.03, o - 0.05, a + 0.05, y + 2.3, o + 0.05, wood);
    m.box(-1.4, m.ground(0, 0.5) - 0.03, 0.15, 1.4, y + 0.88, 0.85, wood);
    for (int i = 0; i < 6; ++i) {
        const double a = -1.3 + 0.44 * i;
        const float tone =
            static_cast<float>(random_between(seed, number * 8 + static_cast<uint64_t>(i), Purpose::tone, 0.85, 1.1));
        m.box(a, y + 0.85, 0.22, a + 0.38, y + 0.98, 0.80, goods[(number + static_cast<uint64_t>(i) * 3) % 5] * tone);
    }
    Geometry &g = pieces.on(SurfaceKind::stone);
    for (int i = 0; i < 8; ++i) {
        const double a0 = -1.75 + 3.5 * i / 8, a1 = -1.75 + 3.5 * (i + 1) / 8;
        const Rgb colour = i % 2 == 0 ? dye : white;
        site.face(g,
                  {market_point(a0, y + 2.15, 1.25), market_point(a1, y + 2.15, 1.25),
                   market_point(a1, y + 2.65, -1.15), market_point(a0, y + 2.65, -1.15)},
                  colour, 4);
        site.face(g,
                  {market_point(a0, y + 2.15, 1.25), market_point(a0, y + 2.65, -1.15),
                   market_point(a1, y + 2.65, -1.15), market_point(a1, y + 2.15, 1.25)},
                  colour * 0.6f, 4);
        site.face(g,
                  {market_point(a0, y + 1.93, 1.27), market_point(a1, y + 1.93, 1.27), market_point(a1, y + 2.15, 1.25),
                   market_point(a0, y + 2.15, 1.25)},
                  colour, 4);
    }
    pieces.finish(Piece::Kind::landmark);
    throw_box(shadows, site, {-1.75, 1.75, -1.15, 1.25}, y, y + 2.4, 0);
}

// Parapets over the embankments of the high street, and the vault for the water under them.
void build_bridge(Pieces &pieces, const Plan &plan, const Terrain &terrain)
{
    const double half = Plan::half_v(Plan::high_street), v = plan.streets_v()[Plan::high_street], u = plan.stream_u();
    for (const double side : {-1.0, 1.0}) {
        const Point out = plan.south(u, v), at = plan.at(u, v + side * half);
        const Site site(at, {side * out.x, side * out.z});
        WallBuilder m(pieces, terrain, site);
        const double road = m.ground(0, -0.3), wet = m.ground(0, 2.5);
        m.box(-13, std::min(m.ground(-13, -0.2), m.ground(13, -0.2)) - 0.03, -0.4, 13, road + 0.95, 0.05,
              market_limestone * 0.86f);
        m.box(-4.6, wet - 0.03, 0.02, 4.6, road + 0.95, 1.0, market_limestone * 0.86f);
        m.box(-13.2, road + 0.95, -0.5, 13.2, road + 1.1, 0.15, market_limestone);
        m.box(-4.8, road + 0.95, -0.1, 4.8, road + 1.1, 1.1, market_limestone);
        Geometry &g = pieces.on(SurfaceKind::stone);
        const double rise = road - wet - 0.25;
        for (int i = 0; i < 10; ++i) {  // the mouth, dark, and its ring of stones
            const auto arch = [&](int k, double grown, double lift) {
                const double t = 3.141592653589793 * k / 10;
                return market_point((-3.0 - grown) * std::cos(t), wet + (rise + grown) * std::sin(t), 1.0 + lift);
            };
            site.face(g, {market_point(0, wet, 1.03), arch(i + 1, 0, 0.03), arch(i, 0, 0.03)}, {0.20f, 0.21f, 0.22f},
                      4);
            site.face(g, {arch(i, 0, 0.06), arch(i + 1, 0, 0.06), arch(i + 1, 0.28, 0.06), arch(i, 0.28, 0.06)},
                      market_limestone * (i % 2 == 0 ? 0.95f : 0.82f), 4);
        }
        pieces.finish(Piece::Kind::landmark);
    }
}

}  // namespace scenes::town
