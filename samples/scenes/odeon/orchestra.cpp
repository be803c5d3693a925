#include "samples/scenes/odeon/orchestra.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/odeon/opus_sectile.h"
#include "samples/scenes/stone.h"

namespace scenes
{
namespace
{

constexpr double panel_m = 1.15, under_podium_m = 0.10;
constexpr int sides = 72;

struct Circle {
    double part, shade;  // of the floor's radius; visible fraction of the sky
};
constexpr Circle circles[] = {{0.84, 1.0}, {0.95, 0.96}, {1.0, 0.80}};

Vec3 at(double x, double z) { return {static_cast<float>(x), 0, static_cast<float>(z)}; }

}  // namespace

Orchestra::Orchestra(const Theatre &theatre, uint64_t seed)
    : seed_(seed), reach_m_(theatre.orchestra_radius_m + under_podium_m)
{
    panels_ = std::max(3, static_cast<int>(2 * reach_m_ / panel_m) | 1);
    const auto point = [&](double part, int side, double shade) {
        const double x = part * std::sin(two_pi * side / sides), z = part * std::cos(two_pi * side / sides);
        const float light = static_cast<float>(shade);
        return floor_.add(at(x * reach_m_, z * reach_m_), {0, 1, 0}, static_cast<float>(0.5 + 0.5 * x),
                          static_cast<float>(0.5 + 0.5 * z), {light, light, light});
    };
    for (int side = 0; side < sides; ++side) {
        const uint32_t middle = point(0, side, 1.0);
        uint32_t a = point(circles[0].part, side, circles[0].shade);
        uint32_t b = point(circles[0].part, side + 1, circles[0].shade);
        floor_.triangle(middle, a, b);
        for (size_t i = 1; i < sizeof circles / sizeof *circles; ++i) {
            const uint32_t c = point(circles[i].part, side + 1, circles[i].shade);
            const uint32_t d = point(circles[i].part, side, circles[i].shade);
            floor_.triangle(a, d, c);
            floor_.triangle(a, c, b);
            a = d, b = c;
        }
    }
}

void Orchestra::surround(Geometry &ground, double reach_m, Rgb colour) const
{
    const auto point = [&](double radius, int side) {
        const Vec3 p = at(std::sin(two_pi * side / sides) * radius, std::cos(two_pi * side / sides) * radius);
        return ground.add(p, {0, 1, 0}, p.x / flagstone_metres, p.z / flagstone_metres, colour);
    };
    constexpr int rings = 6;
    for (int ring = 0; ring < rings; ++ring)
        for (int side = 0; side < sides; ++side) {
            const double in = reach_m_ + (reach_m - reach_m_) * ring / rings;
            const double out = reach_m_ + (reach_m - reach_m_) * (ring + 1) / rings;
            const uint32_t a = point(in, side), b = point(in, side + 1);
            const uint32_t c = point(out, side + 1), d = point(out, side);
            ground.triangle(a, d, c);
            ground.triangle(a, c, b);
        }
}

void Orchestra::prepare(const Gl &gl) { image_.emplace(gl, opus_sectile(seed_, panels_), false); }

void Orchestra::draw(const Gl &g) const
{
    if (!image_) return;
    image_->use();
    floor_.draw(g);
}

}  // namespace scenes
