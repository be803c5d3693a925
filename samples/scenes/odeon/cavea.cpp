#include "samples/scenes/odeon/cavea.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/odeon/stairs.h"
#include "samples/scenes/random.h"
#include "samples/scenes/stone.h"

namespace scenes
{
namespace
{

constexpr Rgb seat_marble = {0.93f, 0.89f, 0.81f}, wall = {0.84f, 0.77f, 0.66f};
constexpr double undercut_m = 0.05, lip_m = 0.13;  // of a seat's front, for the heels
// Paving reaches a little below the adjoining stone, so that there is neither a crack nor a tie in depth.
constexpr double below_m = 0.004;
constexpr double gallery_m = 1.3, gallery_wall_m = 2.7, gallery_thick_m = 0.8;

// A corner of a profile in the plane through the axis. shade: the visible fraction of the sky.
struct Corner {
    double radius, y, shade;
};
using Profile = std::vector<Corner>;

// How far a corner is from the line between two others, in metres; shades count too.
double off(const Corner &c, const Corner &a, const Corner &b)
{
    constexpr double shade_m = 0.5;  // as wrong as a shade that is off by 1
    const double u[3] = {b.radius - a.radius, b.y - a.y, shade_m * (b.shade - a.shade)};
    const double v[3] = {c.radius - a.radius, c.y - a.y, shade_m * (c.shade - a.shade)};
    const double uu = u[0] * u[0] + u[1] * u[1] + u[2] * u[2], uv = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    const double t = uu > 0 ? std::clamp(uv / uu, 0.0, 1.0) : 0;
    return std::hypot(v[0] - t * u[0], v[1] - t * u[1], v[2] - t * u[2]);
}

// As it looks from afar: without the corners that stand out by less than a few centimetres.
void keep(const Profile &profile, size_t first, size_t last, Profile &out)
{
    constexpr double least_m = 0.07;
    double worst = least_m;
    size_t split = 0;
    for (size_t i = first + 1; i < last; ++i)
        if (const double by = off(profile[i], profile[first], profile[last]); by > worst) worst = by, split = i;
    if (split > 0) keep(profile, first, split, out), keep(profile, split, last, out);
    else out.push_back(profile[last]);
}

Profile simple(const Profile &profile)
{
    Profile out = {profile.front()};
    keep(profile, 0, profile.size() - 1, out);
    return out;
}

class CaveaBuilder
{
public:
    CaveaBuilder(Parts &stone, uint64_t seed) : stone_(stone), seed_(seed) {}

    // Sweeps a profile, which runs outwards and upwards like a walk to the last row, in blocks that each have a tone.
    enum class Afar { simple, textured };  // textured: what is large and plain enough to show the grain of its stone
    void sweep(const Profile &profile, double first_deg, double last_deg, double block_m, Rgb colour,
               Afar afar = Afar::simple)
    {
        const double length = (last_deg - first_deg) * radians * profile.front().radius;
        const Profile rough = simple(profile);
        const int blocks = std::max(1, static_cast<int>(length / block_m + 0.5));
        const double each = (last_deg - first_deg) / blocks;
        for (int block = 0; block < blocks; ++block) {
            const Rgb tone = colour * static_cast<float>(random_between(seed_, blocks_++, Purpose::slab, 0.93, 1.04));
            const double from = first_deg + each * block;
            turn(stone_.fine, profile, from, each, 3.5, tone);
            if (afar == Afar::simple) turn(stone_.coarse, rough, from, each, 8, tone);
            stone_.end();
        }
    }

    // The face in which a profile ends at an angle, down to `foot`; side -1 faces decreasing angles.
    void end(const Profile &profile, double at_deg, int side, double foot, Rgb colour)
    {
        for (size_t i = 0; i + 1 < profile.size(); ++i) {
            const Corner &a = profile[i], &b = profile[i + 1];
            if (b.radius - a.radius < 1e-6) continue;
            const std::array<Vec3, 4> face = {at(a.radius, foot, at_deg), at(b.radius, foot, at_deg),
                                              at(b.radius, b.y, at_deg), at(a.radius, a.y, at_deg)};
            if (side < 0) stone_.fine.quad({face[1], face[0], face[3], face[2]}, colour);
            else stone_.fine.quad(face, colour);
        }
        stone_.end();
    }

    static Vec3 at(double radius, double y, double angle_deg)
    {
        return {static_cast<float>(radius * std::sin(angle_deg * radians)), static_cast<float>(y),
                static_cast<float>(-radius * std::cos(angle_deg * radians))};
    }

private:
    // In steps of so many degrees at most.
    void turn(Geometry &out, const Profile &profile, double from_deg, double by_deg, double step_deg, Rgb tone)
    {
        const int steps = std::max(1, static_cast<int>(by_deg / step_deg + 0.999));
        for (int step = 0; step < steps; ++step) {
            const double from = from_deg + by_deg * step / steps;
            band(out, profile, from, from + by_deg / steps, tone);
        }
    }

    void band(Geometry &out, const Profile &profile, double from_deg, double to_deg, Rgb colour)
    {
        double along = 0;
        for (size_t i = 0; i + 1 < profile.size(); ++i) {
            const Corner &a = profile[i], &b = profile[i + 1];
            const double back = b.radius - a.radius, up = b.y - a.y, length = std::sqrt(back * back + up * up);
            if (length < 1e-9) continue;
            uint32_t corners[4];
            for (int k = 0; k < 4; ++k) {
                const Corner &c = k < 2 ? a : b;
                const double angle = k == 0 || k == 3 ? from_deg : to_deg;
                const Vec3 outwards = at(1, 0, angle);
                const float n = static_cast<float>(-up / length);
                corners[k] = out.add(at(c.radius, c.y, angle),
                                     {outwards.x * n, static_cast<float>(back / length), outwards.z * n},
                                     static_cast<float>(angle * radians * profile.front().radius) / plaster_metres,
                                     static_cast<float>(c.radius + along + (k < 2 ? 0 : up)) / plaster_metres,
                                     colour * static_cast<float>(c.shade));
            }
            out.triangle(corners[0], corners[1], corners[2]);
            out.triangle(corners[0], corners[2], corners[3]);
            along += up;
        }
    }

    Parts &stone_;
    uint64_t seed_, blocks_ = 0;
};

class Cavea
{
public:
    Cavea(Parts &stone, const Theatre &theatre, uint64_t seed) : theatre_(theatre), mason_(stone, seed) {}

    void build()
    {
        for (size_t i = 0; i < theatre_.rows.size(); ++i) {
            if (row(i).step_y_m > floor_before(i) + 0.01 && front_of(i) < row(i).radius_m - 1e-6) step(i);
            for (const Wedge &wedge : wedges_of(theatre_, i))
                mason_.sweep(seats(i), wedge.first_deg, wedge.last_deg, 1.3, seat_marble);
            ends(i);
            for (const Gangway &gangway : theatre_.gangways)
                if (i >= gangway.first_row && i <= gangway.last_row) stairs(i, gangway);
        }
        for (const Walkway &walkway : theatre_.walkways) floor(walkway);
        gallery();
    }

private:
    const SeatRow &row(size_t i) const { return theatre_.rows[i]; }
    double sweep_first() const { return theatre_.rows.front().first_deg; }

    double front_of(size_t i) const { return scenes::front_of(theatre_, i); }
    double floor_before(size_t i) const { return scenes::floor_before(theatre_, i); }

    Profile seats(size_t i) const
    {
        const SeatRow &r = row(i);
        const bool more = i + 1 < theatre_.rows.size() && front_of(i + 1) < r.radius_m + r.depth_m + 1e-6;
        const double back = r.radius_m + r.depth_m + (more ? undercut_m : 0);
        return {{r.radius_m + undercut_m, r.step_y_m, 0.55},   {r.radius_m + undercut_m, r.seat_y_m - lip_m, 0.74},
                {r.radius_m, r.seat_y_m - 0.55 * lip_m, 0.90}, {r.radius_m, r.seat_y_m - 0.012, 0.98},
                {r.radius_m + 0.012, r.seat_y_m, 1.0},         {r.radius_m + 0.55 * r.depth_m, r.seat_y_m, 0.98},
                {back, r.seat_y_m, more ? 0.66 : 0.97}};
    }

    // Podium and the step under the feet of the first row.
    void step(size_t i)
    {
        const double front = front_of(i), y = row(i).step_y_m, below = floor_before(i);
        const Profile podium = {{front + 0.04, below, 0.62},      {front + 0.04, y - 0.14, 0.86},
                                {front - 0.03, y - 0.10, 0.92},   {front - 0.03, y, 1.0},
                                {row(i).radius_m - 0.2, y, 0.97}, {row(i).radius_m + undercut_m, y, 0.66}};
        mason_.sweep(podium, row(i).first_deg, row(i).last_deg, 1.7, seat_marble * 0.97f);
        for (const int side : {-1, 1})
            mason_.end(podium, side < 0 ? row(i).first_deg : row(i).last_deg, side, 0, wall * 0.92f);
        for (const Gangway &gangway : theatre_.gangways)
            if (gangway.first_row <= i && gangway.last_row >= i) climb(gangway, front, below, y);
    }

    void climb(const Gangway &gangway, double front, double from, double to)
    {
        const int steps = climbing_steps(from, to);
        for (int k = 1; k < steps; ++k)
            block(gangway, front - stair_run_m * (steps - k), front + 0.1, from, from + (to - from) * k / steps);
    }

    // Two treads a row: one at the seat's own height, and one half a rise higher before the next row.
    void stairs(size_t i, const Gangway &gangway)
    {
        const SeatRow &r = row(i);
        const double half = (r.seat_y_m - r.step_y_m) / 2, run = r.depth_m / 2;
        block(gangway, r.radius_m - run, r.radius_m + 0.1, r.step_y_m, r.step_y_m + half);
        block(gangway, r.radius_m, r.radius_m + r.depth_m + undercut_m, r.step_y_m, r.seat_y_m);
    }

    void block(const Gangway &gangway, double front, double back, double foot, double top)
    {
        const double half_deg = gangway.width_m / 2 / front / radians;
        const double first = gangway.at_deg - half_deg, last = gangway.at_deg + half_deg;
        const Profile tread = {
            {front, foot, 0.66}, {front, top - 0.01, 0.92}, {front + 0.01, top, 1.0}, {back, top, 0.82}};
        mason_.sweep(tread, first, last, 3, seat_marble * 0.93f);
        mason_.end(tread, first, -1, foot, seat_marble * 0.72f);
        mason_.end(tread, last, 1, foot, seat_marble * 0.72f);
    }

    void ends(size_t i)
    {
        for (const int side : {-1, 1})
            mason_.end(seats(i), side < 0 ? row(i).first_deg : row(i).last_deg, side, 0, wall * 0.92f);
    }

    void floor(const Walkway &walkway)
    {
        const double first = theatre_.rows.front().first_deg, last = theatre_.rows.front().last_deg;
        const double y = walkway.y_m - below_m;
        const Profile paving = {
            {walkway.inner_m - 0.1, y, 0.97}, {walkway.outer_m - 0.4, y, 0.95}, {walkway.outer_m + 0.05, y, 0.62}};
        mason_.sweep(paving, first, last, 1.9, seat_marble * 0.90f);
        for (const int side : {-1, 1}) mason_.end(paving, side < 0 ? first : last, side, 0, wall * 0.92f);
    }

    // Behind the last row: a walkway, and a wall with pilasters and a cornice.
    void gallery()
    {
        const SeatRow &last = theatre_.rows.back();
        const double edge = last.radius_m + last.depth_m, in = edge + gallery_m, out = in + gallery_thick_m;
        const double y = last.seat_y_m, top = y + gallery_wall_m;
        const Profile way = {{edge - 0.1, y - below_m, 0.96}, {in - 0.4, y - below_m, 0.9}, {in, y - below_m, 0.6}};
        const Profile face = {{in, y, 0.62}, {in, y + 0.5, 0.85}, {in, top - 0.3, 0.98}};
        const Profile cornice = {{in, top - 0.3, 0.7},
                                 {in - 0.14, top - 0.2, 0.9},
                                 {in - 0.18, top - 0.06, 1},
                                 {in - 0.18, top, 1.04},
                                 {out, top, 1}};
        const Profile back = {{out, top, 1}, {out, 0, 0.7}};
        mason_.sweep(way, last.first_deg, last.last_deg, 1.6, seat_marble * 0.9f);
        mason_.sweep(face, last.first_deg, last.last_deg, 1.2, wall, CaveaBuilder::Afar::textured);
        mason_.sweep(cornice, last.first_deg, last.last_deg, 1.5, seat_marble);
        mason_.sweep(back, last.first_deg, last.last_deg, 1.6, wall * 0.95f, CaveaBuilder::Afar::textured);
        const Profile pilaster = {{in - 0.12, y, 0.7}, {in - 0.12, y + 0.3, 0.95}, {in - 0.12, top - 0.28, 1.05}};
        for (double at = last.first_deg + 2; at < last.last_deg - 1; at += 6) {
            mason_.sweep(pilaster, at, at + 1.1, 1, seat_marble, CaveaBuilder::Afar::textured);
            for (const int side : {-1, 1})
                mason_.end({{in - 0.12, top - 0.28, 1}, {in, top - 0.28, 1}}, side < 0 ? at : at + 1.1, side, y,
                           wall * 0.8f);
        }
        const Profile whole = {{edge, y, 1}, {in, y, 1}, {in + 1e-3, top, 1}, {out, top, 1}};
        for (const int side : {-1, 1})
            mason_.end(whole, side < 0 ? last.first_deg : last.last_deg, side, 0, wall * 0.92f);
    }

    const Theatre &theatre_;
    CaveaBuilder mason_;
};

}  // namespace

void build_cavea(Parts &stone, const Theatre &theatre, uint64_t seed) { Cavea(stone, theatre, seed).build(); }

}  // namespace scenes
