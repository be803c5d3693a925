#include "samples/scenes/plaza_buildings.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/random.h"
#include "samples/scenes/stone.h"

namespace scenes
{
namespace
{

constexpr Rgb travertine = {0.93f, 0.89f, 0.80f}, marble = {0.97f, 0.95f, 0.90f}, ochre = {0.88f, 0.66f, 0.38f};
constexpr Rgb red = {0.62f, 0.22f, 0.16f}, tile = {0.74f, 0.42f, 0.28f}, water = {0.40f, 0.58f, 0.62f};
constexpr Rgb shade = {0.50f, 0.44f, 0.40f}, cypress = {0.17f, 0.26f, 0.15f}, bark = {0.35f, 0.27f, 0.20f};

// A building's own axes: `along` its front, `out` from its front towards the plaza, y up. Turned by multiples of 90
// degrees.
struct Site {
    float x, z;    // centre of the front
    float tx, tz;  // along; out is (-tz, tx) with the sign that points to the plaza
    float ox, oz;

    Vec3 at(float along, float y, float out) const { return {x + tx * along + ox * out, y, z + tz * along + oz * out}; }
    void box(Geometry &g, float a0, float a1, float y0, float y1, float o0, float o1, Rgb colour) const
    {
        const Vec3 p = at(a0, y0, o0), q = at(a1, y1, o1);
        g.box({std::min(p.x, q.x), y0, std::min(p.z, q.z)}, {std::max(p.x, q.x), y1, std::max(p.z, q.z)}, colour);
    }
    // Corners in the building's axes; counter-clockwise seen from before the front.
    void quad(Geometry &g, const std::array<Vec3, 4> &c, Rgb colour) const
    {
        g.quad({at(c[0].x, c[0].y, c[0].z), at(c[1].x, c[1].y, c[1].z), at(c[2].x, c[2].y, c[2].z),
                at(c[3].x, c[3].y, c[3].z)},
               colour);
    }
    void column(Parts &parts, float along, float out, float foot, float height, float radius, int sides) const
    {
        const Vec3 p = at(along, 0, out);
        const float r = radius, top = foot + height;
        const auto plate = [&](Geometry &g, float half, float low, float high) {
            g.box({p.x - half, low, p.z - half}, {p.x + half, high, p.z + half}, marble);
        };
        parts.end();
        plate(parts.fine, 1.35f * r, foot, foot + 0.35f * r);
        parts.fine.turned(p.x, p.z,
                          {{1.3f * r, foot + 0.35f * r},
                           {1.3f * r, foot + 0.6f * r},
                           {1.02f * r, foot + 0.8f * r},
                           {r, foot + height * 0.35f},
                           {0.84f * r, top - 1.1f * r},
                           {0.9f * r, top - 0.95f * r},
                           {1.3f * r, top - 0.4f * r}},
                          sides, marble);
        plate(parts.fine, 1.4f * r, top - 0.4f * r, top);
        plate(parts.coarse, 1.3f * r, foot, foot + 0.6f * r);
        parts.coarse.turned(p.x, p.z,
                            {{1.02f * r, foot + 0.6f * r}, {0.84f * r, top - 1.1f * r}, {1.3f * r, top - 0.4f * r}},
                            sides * 4 / 7, marble);
        plate(parts.coarse, 1.4f * r, top - 0.4f * r, top);
        parts.end();
    }
};

// Visible from below.
void ceiling(Geometry &g, const Site &s, float half, float y, float back, float front)
{
    s.quad(g, {Vec3{-half, y, back}, {half, y, back}, {half, y, front}, {-half, y, front}}, shade);
}

void colonnade(Parts &parts, const Site &s, float length)
{
    Geometry &g = parts.fine;
    const float half = length / 2, steps = 0.36f, depth = 3.4f, high = 4.3f, top = steps + high;
    s.box(g, -half, half, 0, 0.18f, -depth, 0.35f, travertine);
    s.box(g, -half, half, 0.18f, steps, -depth, 0.0f, travertine);
    const int bays = std::max(2, static_cast<int>(length / 2.7f + 0.5f));
    for (int i = 0; i <= bays; ++i)
        s.column(parts, -half + 0.5f + (length - 1.0f) * static_cast<float>(i) / static_cast<float>(bays), -0.45f,
                 steps, high, 0.27f, 14);
    const float wall = -depth + 0.05f;  // in the shade behind the columns: a red dado below ochre
    s.box(g, -half, half, steps, 1.5f, wall - 0.4f, wall + 0.03f, red * 0.72f);
    s.box(g, -half, half, 1.5f, 1.62f, wall - 0.4f, wall + 0.06f, shade);
    s.box(g, -half, half, 1.62f, top, wall - 0.4f, wall, ochre * 0.72f);
    s.box(g, -half, half, top, top + 0.38f, -0.85f, -0.08f, marble);
    s.box(g, -half, half, top + 0.38f, top + 0.75f, -0.80f, -0.14f, ochre);
    s.box(g, -half - 0.2f, half + 0.2f, top + 0.75f, top + 0.95f, -1.0f, 0.18f, marble);
    parts.end();
    ceiling(g, s, half, top, wall, -0.1f);
    s.quad(g,
           {Vec3{-half - 0.3f, top + 0.93f, 0.3f},
            {half + 0.3f, top + 0.93f, 0.3f},
            {half + 0.3f, top + 2.0f, wall - 0.5f},
            {-half - 0.3f, top + 2.0f, wall - 0.5f}},
           tile);
}

void temple(Parts &parts, const Site &s)
{
    Geometry &g = parts.fine;
    const float half = 6.2f, steps = 1.4f, high = 6.6f, top = steps + high;
    for (int i = 0; i < 7; ++i) {
        const float out = 2.4f - 0.34f * static_cast<float>(i);
        s.box(g, -half - 0.25f, half + 0.25f, 0.2f * static_cast<float>(i), 0.2f * static_cast<float>(i + 1), -9, out,
              travertine);
    }
    for (int i = 0; i < 6; ++i) s.column(parts, -5.4f + 2.16f * static_cast<float>(i), -0.55f, steps, high, 0.44f, 20);
    for (int side : {-1, 1}) s.column(parts, 5.4f * static_cast<float>(side), -2.8f, steps, high, 0.44f, 20);
    s.box(g, -half + 0.5f, half - 0.5f, steps, top, -9, -4.6f, ochre * 0.8f);
    s.box(g, -1.3f, 1.3f, steps, steps + 4.2f, -4.65f, -4.55f, {0.30f, 0.24f, 0.17f});
    s.box(g, -1.55f, 1.55f, steps + 4.2f, steps + 4.5f, -4.7f, -4.45f, marble);
    s.box(g, -half, half, top, top + 0.9f, -9, 0.0f, marble);
    s.box(g, -half - 0.3f, half + 0.3f, top + 0.9f, top + 1.15f, -9, 0.35f, marble);
    const float eaves = top + 1.15f, ridge = eaves + 2.1f;
    s.quad(g,
           {Vec3{-half, eaves, -0.25f},
            {half, eaves, -0.25f},
            {0.01f, ridge - 0.2f, -0.25f},
            {-0.01f, ridge - 0.2f, -0.25f}},
           red * 1.1f);
    for (float side : {-1.0f, 1.0f}) {  // the raking cornice, and the roof on it
        const float e = side * (half + 0.35f);
        const std::array<Vec3, 4> cornice = {
            Vec3{e, eaves, 0.35f}, {0, ridge, 0.35f}, {0, ridge - 0.35f, 0.35f}, {side * (half - 0.8f), eaves, 0.35f}};
        const std::array<Vec3, 4> roof = {
            Vec3{e, eaves + 0.02f, 0.4f}, {e, eaves + 0.02f, -9}, {0, ridge + 0.02f, -9}, {0, ridge + 0.02f, 0.4f}};
        if (side > 0) {
            s.quad(g, cornice, marble);
            s.quad(g, roof, tile);
        } else {
            s.quad(g, {cornice[3], cornice[2], cornice[1], cornice[0]}, marble);
            s.quad(g, {roof[3], roof[2], roof[1], roof[0]}, tile);
        }
    }
}

void fountain(Geometry &g, float x, float z, float r)
{
    g.turned(x, z, {{r + 0.35f, 0.0f}, {r + 0.35f, 0.16f}}, 32, travertine);
    g.disc(x, 0.16f, z, r + 0.35f, 32, travertine);
    g.turned(x, z, {{r, 0.16f}, {r - 0.06f, 0.60f}, {r + 0.06f, 0.68f}, {r + 0.06f, 0.78f}}, 32, marble);
    g.disc(x, 0.78f, z, r + 0.06f, 32, marble);
    g.disc(x, 0.785f, z, r - 0.22f, 32, water);
    g.turned(x, z, {{0.42f, 0.7f}, {0.26f, 1.0f}, {0.20f, 1.6f}, {0.32f, 1.75f}, {0.98f, 2.05f}, {1.02f, 2.14f}}, 24,
             marble);
    g.disc(x, 2.14f, z, 1.02f, 24, marble);
    g.disc(x, 2.145f, z, 0.86f, 24, water);
    g.turned(x, z, {{0.16f, 2.1f}, {0.10f, 2.7f}, {0.20f, 2.85f}, {0.04f, 3.25f}, {0.0f, 3.3f}}, 16, marble);
}

void cypresses(Geometry &g, const PlazaLayout &layout, uint64_t seed)
{
    for (uint64_t i = 0; i < 22; ++i) {
        const float along = static_cast<float>(random_between(seed, i, Purpose::place_x, -1.5, 1.5) * layout.half_x);
        const float back = static_cast<float>(-layout.half_z - 14 - 12 * random_unit(seed, i, Purpose::place_z));
        const float high = static_cast<float>(random_between(seed, i, Purpose::tree, 7.5, 12.5));
        const Rgb green = cypress * static_cast<float>(random_between(seed, i, Purpose::tone, 0.85, 1.25));
        g.turned(along, back, {{0.16f, 0.0f}, {0.14f, 1.0f}}, 6, bark);
        g.turned(
            along, back,
            {{0.3f, 0.8f}, {0.85f, 1.8f}, {0.95f, high * 0.35f}, {0.62f, high * 0.7f}, {0.2f, high * 0.93f}, {0, high}},
            9, green);
    }
}

// A horizontal sheet of square cells, each corner's colour at random or by rule.
template <class Colour>
void sheet(Geometry &g, float half_x, float half_z, float cell, float y, float texture_metres, Colour colour)
{
    const int columns = static_cast<int>(2 * half_x / cell) + 1, rows = static_cast<int>(2 * half_z / cell) + 1;
    const uint32_t wide = static_cast<uint32_t>(columns) + 1;
    uint32_t first = 0;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const float x = half_x * static_cast<float>(2 * column - columns) / static_cast<float>(columns);
            const float z = half_z * static_cast<float>(2 * row - rows) / static_cast<float>(rows);
            const uint64_t tile = static_cast<uint64_t>(row) * 4096 + static_cast<uint64_t>(column);
            const uint32_t added =
                g.add({x, y, z}, {0, 1, 0}, x / texture_metres, z / texture_metres, colour(x, z, tile));
            if (row == 0 && column == 0) first = added;
        }
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const uint32_t a = first + static_cast<uint32_t>(row) * wide + static_cast<uint32_t>(column);
            g.triangle(a, a + wide, a + wide + 1);
            g.triangle(a, a + wide + 1, a + 1);
        }
}

}  // namespace

void pave(Geometry &ground, const PlazaLayout &layout, uint64_t seed)
{
    const float half_x = static_cast<float>(layout.half_x) + 5, half_z = static_cast<float>(layout.half_z) + 24;
    sheet(ground, half_x, half_z, 2.5f, 0, flagstone_metres, [&](float, float, uint64_t tile) {
        return Rgb{1.0f, 0.985f, 0.95f} * static_cast<float>(random_between(seed, tile, Purpose::tone, 0.90, 1.0));
    });
}

void grow(Geometry &field, const PlazaLayout &layout, uint64_t seed)
{
    constexpr Rgb grass = {0.50f, 0.53f, 0.33f}, far_away = {0.66f, 0.72f, 0.62f};
    const float half = static_cast<float>(std::max(layout.half_x, layout.half_z)) + 260;
    sheet(field, half, half, 11.0f, -0.08f, plaster_metres, [&](float x, float z, uint64_t tile) {
        const float t = std::min(1.0f, std::sqrt(x * x + z * z) / half);
        const float tone = static_cast<float>(random_between(seed, tile, Purpose::tone, 0.85, 1.1)) * (1 - t) + t;
        return Rgb{grass.r + (far_away.r - grass.r) * t, grass.g + (far_away.g - grass.g) * t,
                   grass.b + (far_away.b - grass.b) * t} *
               tone;
    });
}

void build(Parts &parts, const PlazaLayout &layout, uint64_t seed)
{
    Geometry &g = parts.fine;
    const float hx = static_cast<float>(layout.half_x), hz = static_cast<float>(layout.half_z);
    const float wing = hx - 7.6f;  // the width beside the temple on either side
    temple(parts, {0, -hz - 3.0f, 1, 0, 0, 1});
    for (float side : {-1.0f, 1.0f}) {
        if (wing > 3) colonnade(parts, {side * (hx + 4.5f - (wing + 4.5f) / 2), -hz - 0.9f, 1, 0, 0, 1}, wing + 4.5f);
        colonnade(parts, {side * (hx + 0.9f), -3.0f, 0, side, -side, 0}, 2 * hz - 4.0f);
    }
    parts.end();
    fountain(g, static_cast<float>(layout.fountain[0]), static_cast<float>(layout.fountain[1]),
             static_cast<float>(layout.fountain_radius));
    parts.end();
    const float rx = static_cast<float>(layout.rostra[0]), rz = static_cast<float>(layout.rostra[1]);
    const float rw = static_cast<float>(layout.rostra_half[0]), rd = static_cast<float>(layout.rostra_half[1]);
    const float top = static_cast<float>(layout.rostra_height);
    g.box({rx - rw - 0.12f, 0, rz - rd - 0.12f}, {rx + rw + 0.12f, 0.14f, rz + rd + 0.12f}, travertine);
    g.box({rx - rw, 0.14f, rz - rd}, {rx + rw, top - 0.1f, rz + rd}, marble);
    g.box({rx - rw - 0.08f, top - 0.1f, rz - rd - 0.08f}, {rx + rw + 0.08f, top, rz + rd + 0.08f}, travertine);
    for (int i = 0; i < 3; ++i) {  // steps up at the back
        const float high = 0.225f * static_cast<float>(3 - i), out = 0.3f * static_cast<float>(i + 1);
        g.box({rx - 0.6f, 0, rz + rd}, {rx + 0.6f, high, rz + rd + out}, travertine);
    }
    parts.end();
    cypresses(g, layout, seed);
    parts.end();
}

}  // namespace scenes
