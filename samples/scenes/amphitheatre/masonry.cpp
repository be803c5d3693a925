#include "samples/scenes/amphitheatre/masonry.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/random.h"

namespace scenes::amphitheatre
{
namespace
{

Vec3 unit_normal(const std::array<Vec3, 4> &p)
{
    const Vec3 a = {p[1].x - p[0].x, p[1].y - p[0].y, p[1].z - p[0].z};
    const Vec3 b = {p[3].x - p[0].x, p[3].y - p[0].y, p[3].z - p[0].z};
    const Vec3 n = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    return length > 0 ? Vec3{n.x / length, n.y / length, n.z / length} : Vec3{0, 1, 0};
}

double distance(Vec3 a, Vec3 b)
{
    const double x = static_cast<double>(a.x - b.x), y = static_cast<double>(a.y - b.y),
                 z = static_cast<double>(a.z - b.z);
    return std::sqrt(x * x + y * y + z * z);
}

}  // namespace

Masonry::Masonry(const Plan &plan, const Exposure &exposure, uint64_t seed)
    : plan_(plan), exposure_(exposure), seed_(seed)
{
    for (Sector &sector : sectors_) sector.geometry = Geometry(static_cast<float>(stone_metres));
}

Geometry &Masonry::sector_of(double turn)
{
    const double bay = plan_.oval().length(turn, building_m) / plan_.oval().perimeter(building_m);
    return sectors_[static_cast<size_t>((bay - std::floor(bay)) * sector_count) % sector_count].geometry;
}

Vec3 Masonry::at(double turn, double out, double y) const
{
    const Spot spot = plan_.oval().at(turn, out);
    return {static_cast<float>(spot.x), static_cast<float>(y), static_cast<float>(spot.z)};
}

void Masonry::sweep(const Profile &profile, double first, double last, double step_m, Rgb colour, double spread)
{
    sweep_all(profile, first, last, step_m, colour, spread, -1);
}

void Masonry::sweep_shaded(const Profile &profile, double first, double last, double step_m, Rgb colour)
{
    sweep_all(profile, first, last, step_m, colour, 0.05, 0);
}

void Masonry::sweep_all(const Profile &profile, double first, double last, double step_m, Rgb colour, double spread,
                        double sun)
{
    // Cut where sectors end, so that each of them is a part of the whole round.
    const double round = plan_.oval().perimeter(building_m), each = round / sector_count;
    double from = plan_.oval().length(first, building_m);
    const double to = plan_.oval().length(last, building_m);
    while (from < to - 1e-9) {
        const double next = std::min(to, (std::floor(from / each + 1e-9) + 1) * each);
        const double a = plan_.oval().turn_at(from, building_m), b = plan_.oval().turn_at(next, building_m);
        const double along = plan_.oval().length(b, profile.front().out) - plan_.oval().length(a, profile.front().out);
        const int steps = std::max(1, static_cast<int>(std::ceil(along / step_m - 1e-6)));
        for (size_t i = 0; i + 1 < profile.size(); ++i)
            band(profile[i], profile[i + 1], a, b, steps, colour, spread, sun);
        from = next;
    }
}

void Masonry::band(const Corner &a, const Corner &b, double first, double last, int steps, Rgb colour, double spread,
                   double sun)
{
    const double out = b.out - a.out, up = b.y - a.y, length = std::sqrt(out * out + up * up);
    if (length < 1e-9) return;
    Geometry &stone = sector_of((first + last) / 2);
    uint32_t before[2] = {0, 0};
    for (int step = 0; step <= steps; ++step) {
        const double turn = first + (last - first) * step / steps;
        const Spot spot = plan_.oval().at(turn, a.out);
        const Vec3 normal = {static_cast<float>(-up / length * spot.out_x), static_cast<float>(out / length),
                             static_cast<float>(-up / length * spot.out_z)};
        // Tones of the place, so that stones that meet have one tone where they meet.
        const uint64_t place = static_cast<uint64_t>(std::floor(turn * 4096)) * 0x10001u +
                               static_cast<uint64_t>(a.out * 64) * 0x3000001u + static_cast<uint64_t>(a.y * 64 + 4096);
        const float tone = static_cast<float>(random_between(seed_, place, Purpose::slab, 1 - spread, 1 + spread));
        const float u = static_cast<float>(plan_.oval().length(turn, a.out) / stone_metres);
        uint32_t now[2];
        for (int k = 0; k < 2; ++k) {
            const Corner &c = k == 0 ? a : b;
            const Vec3 p = at(turn, c.out, c.y);
            const Rgb light = sun < 0 ? exposure_.on(p, normal, c.open) : exposure_.with(sun, normal, c.open);
            const double v = (c.out + (k == 0 ? 0 : up)) / stone_metres;
            now[k] = stone.add(p, normal, u, static_cast<float>(v), colour * light * tone);
        }
        if (step > 0) {
            stone.triangle(before[0], now[0], now[1]);
            stone.triangle(before[0], now[1], before[1]);
        }
        before[0] = now[0], before[1] = now[1];
    }
}

void Masonry::quad(const std::array<Vec3, 4> &p, Rgb colour, double open, double sun)
{
    const Vec3 normal = unit_normal(p);
    Vec3 middle = {0, 0, 0};
    for (const Vec3 &c : p) middle.x += c.x / 4, middle.y += c.y / 4, middle.z += c.z / 4;
    Geometry &stone =
        sector_of(plan_.oval().bearing(static_cast<double>(middle.x), static_cast<double>(middle.z)).turn);
    const float wide = static_cast<float>(distance(p[0], p[1]) / stone_metres),
                high = static_cast<float>(distance(p[0], p[3]) / stone_metres);
    const float shift = static_cast<float>(random_unit(seed_, stones_++, Purpose::tone));
    const float us[4] = {0, wide, wide, 0}, vs[4] = {0, 0, high, high};
    uint32_t made[4];
    for (size_t k = 0; k < 4; ++k) {
        const Rgb light = sun < 0 ? exposure_.on(p[k], normal, open) : exposure_.with(sun, normal, open);
        made[k] = stone.add(p[k], normal, us[k] + shift, vs[k], colour * light);
    }
    stone.triangle(made[0], made[1], made[2]);
    stone.triangle(made[0], made[2], made[3]);
}

void Masonry::cheek(double turn, double from, double to, double foot, double from_top, double to_top, int side,
                    Rgb colour)
{
    const Vec3 a = at(turn, from, foot), b = at(turn, to, foot), c = at(turn, to, to_top), d = at(turn, from, from_top);
    if (side > 0) quad({a, b, c, d}, colour, 0.7);
    else quad({b, a, d, c}, colour, 0.7);
}

void Masonry::block(double turn, double half_m, double from, double to, double foot, double top, Rgb colour)
{
    const double half = half_m / plan_.oval().radius(turn, (from + to) / 2);
    const double l = turn - half, h = turn + half;
    quad({at(l, from, foot), at(h, from, foot), at(h, from, top), at(l, from, top)}, colour, 0.8);
    quad({at(h, to, foot), at(l, to, foot), at(l, to, top), at(h, to, top)}, colour, 0.6);
    quad({at(l, from, top), at(h, from, top), at(h, to, top), at(l, to, top)}, colour, 1);
    cheek(l, from, to, foot, top, top, -1, colour);
    cheek(h, from, to, foot, top, top, 1, colour);
}

void Masonry::column(double turn, double out, double foot, double top, double radius, int sides, Rgb colour)
{
    const Vec3 middle = at(turn, out, foot);
    for (int side = 0; side < sides; ++side) {
        const auto rim = [&](int k, double y) {
            const double a = turn + two_pi * k / sides;
            return Vec3{middle.x + static_cast<float>(radius * std::cos(a)), static_cast<float>(y),
                        middle.z + static_cast<float>(radius * std::sin(a))};
        };
        quad({rim(side + 1, foot), rim(side, foot), rim(side, top), rim(side + 1, top)}, colour, 0.75);
    }
}

void Masonry::recess(double turn, double half_m, double out, double foot, double top, Rgb colour)
{
    panel(turn, half_m, out, foot, top, colour, 0);
}

void Masonry::panel(double turn, double half_m, double out, double foot, double top, Rgb colour, double sun)
{
    const double half = half_m / plan_.oval().radius(turn, out);
    quad({at(turn - half, out, foot), at(turn + half, out, foot), at(turn + half, out, top), at(turn - half, out, top)},
         colour, sun < 0 ? 0.85 : 0.5, sun);
}

void Masonry::bound(Sector &sector)
{
    Vec3 low = {1e9f, 1e9f, 1e9f}, high = {-1e9f, -1e9f, -1e9f};
    for (const SceneryVertex &v : sector.geometry.vertices()) {
        const Vec3 p = v.position;
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3 middle = {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
    sector.sphere = {middle, 0.500001f * static_cast<float>(distance(low, high))};
}

void Masonry::draw(const Gl &g, const Eye &eye) const
{
    const Frustum view(eye);
    for (Sector &sector : sectors_) {
        if (sector.geometry.indices().empty()) continue;
        if (sector.sphere.radius < 0) bound(sector);
        if (view.meets(sector.sphere)) sector.geometry.draw(g);
    }
}

size_t Masonry::triangles() const
{
    size_t sum = 0;
    for (const Sector &sector : sectors_) sum += sector.geometry.indices().size() / 3;
    return sum;
}

}  // namespace scenes::amphitheatre
