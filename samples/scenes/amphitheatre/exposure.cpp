#include "samples/scenes/amphitheatre/exposure.h"

#include <algorithm>
#include <cmath>

namespace scenes::amphitheatre
{
namespace
{

constexpr double rim_out_m = 50.5;  // of the inner face of the outer wall
constexpr double soft_m = 0.8;      // half the height of its shadow's edge
constexpr double longest_m = 400;   // horizontally, of a ray inside
constexpr double skin_cosine =
    0.26;  // of a person's surface towards the sun, on average, less the light of people around

double dot(Vec3 a, Vec3 b)
{
    return static_cast<double>(a.x) * static_cast<double>(b.x) + static_cast<double>(a.y) * static_cast<double>(b.y) +
           static_cast<double>(a.z) * static_cast<double>(b.z);
}

double grey(Rgb c) { return static_cast<double>(c.r + c.g + c.b) / 3; }

}  // namespace

Rgb operator*(Rgb a, Rgb b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }

Exposure::Exposure(const Plan &plan, const Velarium &velarium, const Daylight &light)
    : plan_(plan), velarium_(velarium), light_(light)
{
}

double Exposure::sun_at(Vec3 at) const
{
    const double sx = static_cast<double>(light_.to_sun.x), sy = static_cast<double>(light_.to_sun.y),
                 sz = static_cast<double>(light_.to_sun.z);
    const double level = std::sqrt(sx * sx + sz * sz);
    const double x = static_cast<double>(at.x), y = static_cast<double>(at.y), z = static_cast<double>(at.z);
    double seen = 1;
    if (level > 1e-6 && plan_.oval().bearing(x, z).out < rim_out_m) {
        double low = 0, high = longest_m / level;
        for (int i = 0; i < 14; ++i) {
            const double s = (low + high) / 2;
            if (plan_.oval().bearing(x + s * sx, z + s * sz).out < rim_out_m) low = s;
            else high = s;
        }
        seen = std::clamp((y + low * sy - height_m) / (2 * soft_m) + 0.5, 0.0, 1.0);
    }
    return seen > 0 ? seen * velarium_.passes(at) : 0;
}

Rgb Exposure::on(Vec3 at, Vec3 normal, double open) const
{
    return with(dot(normal, light_.to_sun) > 0 ? sun_at(at) : 0, normal, open);
}

Rgb Exposure::with(double sun, Vec3 normal, double open) const
{
    const double facing = std::max(0.0, dot(normal, light_.to_sun)) * sun;
    const Vec3 away = {-light_.to_sun.x, 0.3f, -light_.to_sun.z};
    const double back = 0.35 + 0.65 * std::max(0.0, dot(normal, away));
    const double sky = open * (0.72 + 0.28 * static_cast<double>(normal.y));
    const auto sum = [&](float of_sun, float of_sky, float of_bounce) {
        return static_cast<float>(static_cast<double>(of_sun) * facing + static_cast<double>(of_sky) * sky +
                                  static_cast<double>(of_bounce) * back * open);
    };
    return {sum(light_.sun.r, light_.sky.r, light_.bounce.r), sum(light_.sun.g, light_.sky.g, light_.bounce.g),
            sum(light_.sun.b, light_.sky.b, light_.bounce.b)};
}

double Exposure::of_person(Vec3 head) const
{
    const double shade = grey(light_.sky) + 0.5 * grey(light_.bounce), sun = grey(light_.sun) * skin_cosine;
    return (shade + sun * sun_at(head)) / (shade + sun);
}

}  // namespace scenes::amphitheatre
