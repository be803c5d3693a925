#include "samples/scenes/sky.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/distance.h"

namespace scenes
{
namespace
{

constexpr Rgb zenith = {0.27f, 0.47f, 0.74f}, middle = {0.52f, 0.69f, 0.86f}, haze = {0.86f, 0.88f, 0.88f};
constexpr Rgb country = {0.60f, 0.66f, 0.57f};
constexpr int sides = 96;
constexpr double ground_below = -0.2;  // the sine of the lowest angle to the horizon, in the part that ground may hide

Rgb mix(Rgb a, Rgb b, float t) { return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t}; }

Rgb sky_at(double height)  // the sine of the angle above the horizon
{
    if (height <= -0.02) return country;
    if (height <= 0) return haze;
    const float t = static_cast<float>(std::sqrt(height));
    return t < 0.45f ? mix(haze, middle, t / 0.45f) : mix(middle, zenith, (t - 0.45f) / 0.55f);
}

// Rolling heights that join at the ends.
double hill(uint64_t seed, int side, double height, int waves)
{
    double sum = 0;
    for (int octave = 0; octave < 4; ++octave) {
        const double shift =
            static_cast<double>((seed * 37 + static_cast<uint64_t>(octave) * 101) % 360) * (two_pi / 360);
        sum += std::sin(two_pi * side / sides * (waves * (octave + 1) + octave) + shift) / (1.4 * octave + 1);
    }
    return height * (1 + 0.38 * sum);
}

// True if each edge of the ground is visible above ground_below.
bool hides(double ground_m, const Eye &eye)
{
    const double edge_m = ground_m - std::max(std::abs(eye.position[0]), std::abs(eye.position[2]));
    return edge_m > 0 && eye.position[1] > 0 && eye.position[1] < -ground_below * std::hypot(eye.position[1], edge_m);
}

// False if all of it lies outside the view's left edge, or outside its right one.
bool in_view(const Geometry &far_away, const Eye &eye)
{
    const float *p = eye.projection, *r = eye.rotation;
    bool left = true, right = true;
    for (const SceneryVertex &vertex : far_away.vertices()) {
        const Vec3 at = vertex.position;
        double v[3], clip[2];  // x and w
        for (int i = 0; i < 3; ++i)
            v[i] = double(r[i]) * double(at.x) + double(r[4 + i]) * double(at.y) + double(r[8 + i]) * double(at.z);
        for (int i = 0; i < 2; ++i)
            clip[i] = double(p[3 * i]) * v[0] + double(p[3 * i + 4]) * v[1] + double(p[3 * i + 8]) * v[2];
        left = left && clip[0] < -clip[1];
        right = right && clip[0] > clip[1];
    }
    return !far_away.vertices().empty() && !left && !right;
}

}  // namespace

template <class Low, class High>
void Sky::strip(Low low, High high, Rgb low_colour, Rgb high_colour)
{
    Geometry *parts = low(0) < ground_below ? below_ : dome_;
    uint32_t last_low = 0, last_high = 0;
    for (int side = 0; side <= sides; ++side) {
        const double turn = two_pi * side / sides;
        const auto add = [&](Geometry &part, double y, Rgb colour) {
            const double level = std::sqrt(1 - y * y);
            return part.add({static_cast<float>(level * std::sin(turn)), static_cast<float>(y),
                             static_cast<float>(level * std::cos(turn))},
                            {0, 1, 0}, 0, 0, colour);
        };
        const int sector = side * sectors / sides;
        if (side > 0) {
            Geometry &part = parts[(side - 1) * sectors / sides];
            const uint32_t a = add(part, low(side), low_colour), b = add(part, high(side), high_colour);
            part.triangle(last_low, a, b);
            part.triangle(last_low, b, last_high);
            last_low = a, last_high = b;
        }
        if (side < sides && side % (sides / sectors) == 0) {
            last_low = add(parts[sector], low(side), low_colour);
            last_high = add(parts[sector], high(side), high_colour);
        }
    }
}

Sky::Sky(uint64_t seed, Land land)
{
    if (land == Land::studio) {
        studio();
        return;
    }
    const auto at = [](double y) { return [y](int) { return y; }; };
    strip(at(-0.999), at(ground_below), country, country);
    const double steps[] = {ground_below, -0.05, -0.02, 0.0, 0.02, 0.05, 0.1,   0.16,
                            0.24,         0.34,  0.46,  0.6, 0.76, 0.9,  0.9999};
    for (size_t i = 0; i + 1 < sizeof steps / sizeof *steps; ++i)
        strip(at(steps[i]), at(steps[i + 1]), sky_at(steps[i]), sky_at(steps[i + 1]));
    const auto hills = [](uint64_t of, double height, int waves) {
        return [=](int side) { return hill(of, side, height, waves); };
    };
    strip(at(-0.06), hills(seed + 1, 0.040, 3), {0.72f, 0.78f, 0.80f}, {0.64f, 0.72f, 0.78f});
    strip(at(-0.06), hills(seed + 5, 0.016, 5), {0.62f, 0.68f, 0.60f}, {0.52f, 0.61f, 0.56f});
}

// A photographer's backdrop.
void Sky::studio()
{
    const auto at = [](double y) { return [y](int) { return y; }; };
    const Rgb top = backdrop * 0.62f;
    strip(at(-0.999), at(0.0), backdrop, backdrop);
    strip(at(0.0), at(0.45), backdrop, top);
    strip(at(0.45), at(0.9999), top, top);
}

void Sky::draw(const Gl &g, const Eye &eye, double ground_m) const
{
    // A sphere of radius 1 could be nearer than the near plane; ten metres is beyond the near plane of all scenes.
    begin_distance(g, eye, 10);
    const bool all = !hides(ground_m, eye);
    for (int sector = 0; sector < sectors; ++sector) {
        if (all && in_view(below_[sector], eye)) below_[sector].draw(g);
        if (in_view(dome_[sector], eye)) dome_[sector].draw(g);
    }
    end_distance(g, eye);
}

}  // namespace scenes
