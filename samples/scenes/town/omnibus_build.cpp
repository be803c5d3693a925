// The parts of an omnibus: benches, panels, an engine under a bonnet, spoked wheels.
#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/town/omnibus.h"

namespace scenes::town
{
namespace
{

constexpr Rgb cream = {0.95f, 0.90f, 0.76f}, leather = {0.48f, 0.27f, 0.18f}, wood = {0.66f, 0.50f, 0.33f};
constexpr Rgb boards = {0.50f, 0.40f, 0.30f}, omnibus_iron = {0.20f, 0.20f, 0.22f}, brass = {0.88f, 0.70f, 0.32f};
constexpr Rgb canvas = {0.80f, 0.74f, 0.60f}, rubber = {0.22f, 0.22f, 0.23f}, glow = {0.99f, 0.97f, 0.88f};

// Seats fit the seated characters (the height of the seat, and its front edge behind the feet).
constexpr float seat_top_m = 0.43f, seat_edge_m = 0.14f, bench_deep_m = 0.46f, row_m = 0.97f, first_row_z = 1.05f;
constexpr int rows = 5;

constexpr float floor_y = static_cast<float>(Omnibus::floor_m), half_x = static_cast<float>(Omnibus::half_width_m);
constexpr float rear_z = static_cast<float>(Omnibus::rear_m), front_z = static_cast<float>(Omnibus::front_m);

// Both sides of a slab between two outlines, and its rim.
void mirrored_box(Geometry &g, Vec3 first, Vec3 last, Rgb colour)
{
    g.box(first, last, colour);
    g.box({-last.x, first.y, first.z}, {-first.x, last.y, last.z}, colour);
}

struct Profile {
    double radius, x;
};

// A surface of revolution about the x axis through (y, z), profile from the left to the right.
void lathe(Geometry &g, double x, double y, double z, const std::vector<Profile> &profile, int sides, Rgb colour)
{
    for (size_t k = 0; k + 1 < profile.size(); ++k) {
        const Profile a = profile[k], b = profile[k + 1];
        const double dx = b.x - a.x, dr = b.radius - a.radius, length = std::sqrt(dx * dx + dr * dr);
        const double out = dx / length, along = -dr / length;
        uint32_t last = 0;
        for (int side = 0; side <= sides; ++side) {
            const double turn = two_pi * side / sides, s = std::sin(turn), c = std::cos(turn);
            const Vec3 normal = {static_cast<float>(along), static_cast<float>(out * c), static_cast<float>(out * s)};
            const auto at = [&](const Profile &p) {
                return g.add({static_cast<float>(x + p.x), static_cast<float>(y + p.radius * c),
                              static_cast<float>(z + p.radius * s)},
                             normal, static_cast<float>(side) / static_cast<float>(sides), 0, colour);
            };
            const uint32_t left = at(a), right = at(b);
            if (side > 0) {
                if (a.radius > 0) g.triangle(last, left, right);
                if (b.radius > 0) g.triangle(last, right, last + 1);
            }
            last = left;
        }
    }
}

// A bent sheet over a wheel, visible from both sides.
void mudguard(Geometry &g, float x0, float x1, float z, Rgb colour)
{
    constexpr int parts = 7;
    const double radius = Omnibus::wheel_radius_m + 0.11;
    const auto at = [&](float x, int i, double r) {
        const double turn = -1.25 + 2.5 * i / parts;
        return Vec3{x, static_cast<float>(Omnibus::wheel_radius_m + r * std::cos(turn)),
                    z + static_cast<float>(r * std::sin(turn))};
    };
    for (int i = 0; i < parts; ++i) {
        g.quad({at(x0, i, radius), at(x0, i + 1, radius), at(x1, i + 1, radius), at(x1, i, radius)}, colour);
        g.quad({at(x0, i + 1, radius - 0.02), at(x0, i, radius - 0.02), at(x1, i, radius - 0.02),
                at(x1, i + 1, radius - 0.02)},
               colour * 0.5f);
        g.quad({at(x1, i, radius - 0.05), at(x1, i, radius), at(x1, i + 1, radius), at(x1, i + 1, radius - 0.05)},
               colour);
    }
}

// A bench from side to side: a box of wood, a cushion, a back that leans.
void bench(Geometry &g, float feet_z, Rgb paint)
{
    const float top = floor_y + seat_top_m, z1 = feet_z - seat_edge_m, z0 = z1 - bench_deep_m;
    g.box({-half_x + 0.06f, floor_y, z0}, {half_x - 0.06f, top - 0.09f, z1 - 0.05f}, wood);
    g.box({-half_x + 0.06f, top - 0.10f, z0}, {half_x - 0.06f, top, z1}, leather);
    const float back = top + 0.50f, lean = 0.10f, thick = 0.09f, wide = half_x - 0.06f;
    const Vec3 f0 = {-wide, top, z0 + 0.02f}, f1 = {wide, top, z0 + 0.02f};
    const Vec3 t1 = {wide, back, z0 - lean}, t0 = {-wide, back, z0 - lean};
    const Vec3 b0 = {-wide, floor_y, z0 - thick * 0.4f}, b1 = {wide, floor_y, z0 - thick * 0.4f};
    const Vec3 u0 = {-wide, back, z0 - lean - thick}, u1 = {wide, back, z0 - lean - thick};
    g.quad({f0, f1, t1, t0}, leather * 1.08f);
    g.quad({b1, b0, u0, u1}, paint);
    g.quad({t0, t1, u1, u0}, wood);
    g.quad({f1, b1, u1, t1}, wood);
    g.quad({b0, f0, t0, u0}, wood);
}

// The side of a row: a panel that rises to the bench's back.
void end_panel(Geometry &g, float feet_z, Rgb paint)
{
    const float top = floor_y + seat_top_m, z1 = feet_z - 0.02f, z0 = feet_z - seat_edge_m - bench_deep_m - 0.1f;
    for (const float side : {-1.0f, 1.0f}) {
        const float x = side * half_x, in = side * (half_x - 0.05f);
        const Vec3 outline[] = {{x, floor_y, z1},
                                {x, top - 0.12f, z1 - 0.10f},
                                {x, top + 0.16f, z1 - 0.28f},
                                {x, top + 0.36f, z0},
                                {x, floor_y, z0}};
        constexpr int corners = 5;
        const auto inner = [&](int i) { return Vec3{in, outline[i].y, outline[i].z}; };
        for (int i = 1; i + 1 < corners; ++i) {
            // Each triangle of a fan twice, as an outside and an inside face.
            for (const bool outside : {true, false}) {
                const Vec3 a = outside ? outline[0] : inner(0), b = outside ? outline[i] : inner(i);
                const Vec3 c = outside ? outline[i + 1] : inner(i + 1);
                const Vec3 normal = {outside ? side : -side, 0, 0};
                const Rgb colour = outside ? paint : wood;
                const uint32_t n = g.add(a, normal, a.z * 0.25f, a.y * 0.25f, colour);
                g.add(b, normal, b.z * 0.25f, b.y * 0.25f, colour);
                g.add(c, normal, c.z * 0.25f, c.y * 0.25f, colour);
                // Forward to back and up, seen from +x, runs counter-clockwise.
                if ((side > 0) == outside) g.triangle(n, n + 2, n + 1);
                else g.triangle(n, n + 1, n + 2);
            }
        }
        for (int i = 0; i + 2 < corners; ++i) {
            if (side > 0) g.quad({outline[i], inner(i), inner(i + 1), outline[i + 1]}, brass);
            else g.quad({inner(i), outline[i], outline[i + 1], inner(i + 1)}, brass);
        }
    }
}

// An engine under a bonnet, radiator, lamps, bumper.
void nose(Geometry &g, Rgb paint)
{
    const float dash = 1.62f, y0 = 0.50f;
    g.box({-half_x, y0, dash - 0.06f}, {half_x, floor_y + 0.62f, dash}, paint);
    g.box({-half_x - 0.02f, floor_y + 0.60f, dash - 0.08f}, {half_x + 0.02f, floor_y + 0.66f, dash + 0.02f}, brass);
    const float waist = 1.08f, top = 1.34f, wide = 0.56f, crown = 0.34f, z0 = dash, z1 = front_z - 0.14f;
    mirrored_box(g, {0, y0, z0}, {wide, waist, z1}, paint);
    for (const float s : {-1.0f, 1.0f}) {
        const Vec3 a = {s * wide, waist, z1}, b = {s * wide, waist, z0}, c = {s * crown, top, z0},
                   d = {s * crown, top, z1};
        if (s > 0) g.quad({a, b, c, d}, paint * 1.04f);
        else g.quad({b, a, d, c}, paint * 1.04f);
    }
    g.quad({Vec3{-crown, top, z1}, {crown, top, z1}, {crown, top, z0}, {-crown, top, z0}}, paint * 1.06f);
    for (int i = 0; i < 6; ++i)  // louvres
        mirrored_box(g, {wide, 0.72f, z0 + 0.22f + 0.18f * static_cast<float>(i)},
                     {wide + 0.015f, 1.0f, z0 + 0.30f + 0.18f * static_cast<float>(i)}, paint * 0.55f);
    g.box({-wide - 0.03f, y0, z1}, {wide + 0.03f, top + 0.06f, front_z}, brass);
    g.box({-wide + 0.06f, y0 + 0.08f, front_z}, {wide - 0.06f, top - 0.06f, front_z + 0.012f}, omnibus_iron);
    for (int i = 0; i < 7; ++i) {
        const float x = -0.42f + 0.14f * static_cast<float>(i);
        g.box({x - 0.012f, y0 + 0.08f, front_z + 0.012f}, {x + 0.012f, top - 0.06f, front_z + 0.03f}, brass);
    }
    g.turned(0, front_z - 0.07f, {{0.07f, top + 0.06f}, {0.08f, top + 0.13f}, {0, top + 0.15f}}, 8, brass);
    for (const float s : {-1.0f, 1.0f}) {  // lamps on brackets
        const float x = s * 0.80f, z = front_z - 0.30f;
        g.box({x - 0.03f, 0.56f, z - 0.06f}, {x + 0.03f, 0.98f, z}, omnibus_iron);
        g.box({x - 0.13f, 0.90f, z - 0.14f}, {x + 0.13f, 1.18f, z + 0.10f}, brass);
        g.box({x - 0.10f, 0.93f, z + 0.10f}, {x + 0.10f, 1.15f, z + 0.115f}, glow);
    }
    g.box({-1.05f, 0.44f, front_z + 0.02f}, {1.05f, 0.54f, front_z + 0.10f}, omnibus_iron);
}

// The steering wheel on its column, and a pane's frame before the first row.
void cockpit(Geometry &g)
{
    const Omnibus::Seat driver = Omnibus::seats().front();
    const Vec3 middle = {driver.x, floor_y + 0.74f, driver.z + 0.24f};
    const double tilt_c = 0.82, tilt_s = 0.57;  // of the wheel's plane, its upper rim forward
    constexpr int sides = 14;
    const auto rim = [&](int i, double radius, double lift) {
        const double t = two_pi * i / sides, u = radius * std::cos(t), v = radius * std::sin(t);
        return Vec3{middle.x + static_cast<float>(u), middle.y + static_cast<float>(v * tilt_s + lift * tilt_c),
                    middle.z + static_cast<float>(v * tilt_c - lift * tilt_s)};
    };
    for (int i = 0; i < sides; ++i) {
        g.quad({rim(i + 1, 0.18, 0.012), rim(i, 0.18, 0.012), rim(i, 0.22, 0.012), rim(i + 1, 0.22, 0.012)}, wood);
        g.quad({rim(i, 0.18, -0.012), rim(i + 1, 0.18, -0.012), rim(i + 1, 0.22, -0.012), rim(i, 0.22, -0.012)},
               wood * 0.7f);
        g.quad({rim(i, 0.22, 0.012), rim(i, 0.22, -0.012), rim(i + 1, 0.22, -0.012), rim(i + 1, 0.22, 0.012)}, wood);
        if (i % 4 == 0) g.quad({rim(i, 0.0, 0.0), rim(i, 0.19, 0), rim(i + 1, 0.19, 0), rim(i + 1, 0.02, 0)}, brass);
    }
    g.box({middle.x - 0.025f, floor_y, middle.z + 0.02f}, {middle.x + 0.025f, middle.y - 0.02f, middle.z + 0.07f},
          omnibus_iron);
    const float z = 1.60f, low = floor_y + 0.66f, high = floor_y + 1.30f;
    mirrored_box(g, {half_x - 0.16f, low, z - 0.02f}, {half_x - 0.12f, high, z + 0.02f}, brass);
    for (const float y : {low + 0.02f, high - 0.04f})
        g.box({-half_x + 0.12f, y, z - 0.018f}, {half_x - 0.12f, y + 0.04f, z + 0.018f}, brass);
}

}  // namespace

const std::vector<Omnibus::Seat> &Omnibus::seats()
{
    static const std::vector<Seat> all = [] {
        std::vector<Seat> made = {{0.58f, floor_y, first_row_z}, {-0.58f, floor_y, first_row_z}};
        for (int row = 1; row < rows; ++row)
            for (const float x : {0.72f, 0.0f, -0.72f})
                made.push_back({x, floor_y, first_row_z - row_m * static_cast<float>(row)});
        return made;
    }();
    return all;
}

Omnibus::Omnibus(Rgb paint)
{
    build_body(paint);
    build_wheels();
    const float half_z = (front_z + 0.1f - rear_z) / 2;
    const Vec3 middle = {0, 1.1f, (front_z + 0.1f + rear_z) / 2};
    sphere_ = {middle, std::sqrt(half_z * half_z + 1.3f * 1.3f + 1.1f * 1.1f)};
}

void Omnibus::build_body(Rgb paint)
{
    Geometry &g = body_;
    mirrored_box(g, {0.42f, 0.40f, rear_z + 0.2f}, {0.54f, 0.56f, front_z - 0.1f}, omnibus_iron);  // frame and axles
    for (const float z : {-1.0f, 1.0f}) {
        const float at = z * static_cast<float>(wheelbase_m) / 2;
        g.box({-1.0f, 0.42f, at - 0.05f}, {1.0f, 0.52f, at + 0.05f}, omnibus_iron);
    }
    g.box({-half_x, floor_y - 0.12f, rear_z}, {half_x, floor_y, 1.60f}, boards);
    mirrored_box(g, {half_x, floor_y - 0.14f, rear_z}, {half_x + 0.03f, floor_y + 0.02f, 1.60f}, paint);
    mirrored_box(g, {half_x + 0.03f, floor_y - 0.09f, rear_z}, {half_x + 0.04f, floor_y - 0.04f, 1.60f}, cream);
    for (int row = 0; row < rows; ++row) {
        bench(g, first_row_z - row_m * static_cast<float>(row), paint);
        end_panel(g, first_row_z - row_m * static_cast<float>(row), paint);
    }
    // The rear, with the hood rolled up on it.
    g.box({-half_x, floor_y, rear_z}, {half_x, floor_y + 0.86f, rear_z + 0.06f}, paint);
    g.box({-half_x + 0.12f, floor_y + 0.16f, rear_z - 0.012f}, {half_x - 0.12f, floor_y + 0.62f, rear_z}, cream);
    lathe(g, 0, floor_y + 0.98, rear_z + 0.06, {{0, -1.16}, {0.13, -1.14}, {0.15, 0}, {0.13, 1.14}, {0, 1.16}}, 8,
          canvas);
    for (const float x : {-0.8f, 0.0f, 0.8f})
        lathe(g, x, floor_y + 0.98, rear_z + 0.06, {{0.15, -0.03}, {0.157, -0.03}, {0.157, 0.03}, {0.15, 0.03}}, 8,
              leather);
    mirrored_box(g, {0.95f, 0.30f, -1.35f}, {half_x + 0.16f, 0.35f, 1.35f}, wood);  // running boards
    mirrored_box(g, {1.05f, 0.35f, -0.6f}, {1.09f, floor_y - 0.12f, -0.55f}, omnibus_iron);
    mirrored_box(g, {1.05f, 0.35f, 0.6f}, {1.09f, floor_y - 0.12f, 0.65f}, omnibus_iron);
    for (const float z : {-1.0f, 1.0f})
        for (const float side : {-1.0f, 1.0f}) {
            const float inner = side * 1.0f, outer = side * 1.33f, at = z * static_cast<float>(wheelbase_m) / 2;
            if (z > 0) mudguard(g, std::min(inner, outer), std::max(inner, outer), at, paint * 0.9f);
        }
    nose(g, paint);
    cockpit(g);
}

void Omnibus::build_wheels()
{
    const double r = wheel_radius_m;
    constexpr int sides = 16, spokes = 10;
    lathe(wheel_, 0, 0, 0,
          {{r - 0.075, -0.05}, {r - 0.02, -0.062}, {r, -0.03}, {r, 0.03}, {r - 0.02, 0.062}, {r - 0.075, 0.05}}, sides,
          rubber);
    lathe(wheel_, 0, 0, 0, {{r - 0.075, 0.05}, {r - 0.14, 0.045}, {r - 0.14, -0.045}, {r - 0.075, -0.05}}, sides,
          cream);
    lathe(wheel_, 0, 0, 0, {{0, -0.09}, {0.085, -0.08}, {0.095, 0.08}, {0.05, 0.11}, {0.05, 0.14}, {0, 0.145}}, 10,
          brass);
    for (int spoke = 0; spoke < spokes; ++spoke) {
        const double t = two_pi * spoke / spokes, s = std::sin(t), c = std::cos(t);
        const auto at = [&](double x, double out, double aside) {
            return Vec3{static_cast<float>(x), static_cast<float>(out * c - aside * s),
                        static_cast<float>(out * s + aside * c)};
        };
        const double in = 0.07, out = r - 0.13, w = 0.024, d = 0.026;
        wheel_.quad({at(d, in, -w), at(d, out, -w), at(d, out, w), at(d, in, w)}, cream);
        wheel_.quad({at(-d, in, w), at(-d, out, w), at(-d, out, -w), at(-d, in, -w)}, cream);
        wheel_.quad({at(-d, in, -w), at(-d, out, -w), at(d, out, -w), at(d, in, -w)}, cream * 0.85f);
        wheel_.quad({at(d, in, w), at(d, out, w), at(-d, out, w), at(-d, in, w)}, cream * 0.85f);
    }
    lathe(far_wheel_, 0, 0, 0, {{r - 0.1, -0.06}, {r, -0.05}, {r, 0.05}, {r - 0.1, 0.06}}, 9, rubber);
    lathe(far_wheel_, 0, 0, 0, {{0, -0.05}, {r - 0.1, -0.05}}, 9, cream * 0.8f);
    lathe(far_wheel_, 0, 0, 0, {{r - 0.1, 0.05}, {0, 0.05}}, 9, cream * 0.8f);
}

}  // namespace scenes::town
