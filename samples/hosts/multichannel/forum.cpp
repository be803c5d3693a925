#include "samples/hosts/multichannel/forum.h"

#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/random.h"
#include "samples/scenes/stone.h"

namespace multichannel
{
namespace
{

using namespace scenes;

constexpr uint64_t forum_seed = 5;
constexpr float person_height_m = 1.75f, shadow_width_m = 0.95f;

}  // namespace

Forum::Pictures::Pictures(const Gl &gl)
    : flagstones_(gl, flagstones(forum_seed), true), plaster_(gl, plaster(forum_seed), true)
{
    shadows_.prepare(gl);
}

Forum::Forum() : sky_(forum_seed, Sky::Land::hills), stone_(plaster_metres)
{
    pave();
    build_colonnade();
}

Daylight Forum::light() { return {}; }

// Tiles of two metres with broad stains, out to beyond the colonnade.
void Forum::pave()
{
    constexpr int half = 40;
    constexpr float tile_m = 2;
    const auto corner = [&](int x, int z) {
        const uint64_t tile = static_cast<uint64_t>((x + half) * 1000 + z + half);
        const float tone = static_cast<float>(random_between(forum_seed, tile, Purpose::tone, 0.90, 1.0));
        return ground_.add({tile_m * static_cast<float>(x), 0, tile_m * static_cast<float>(z)}, {0, 1, 0},
                           tile_m * static_cast<float>(x) / flagstone_metres,
                           tile_m * static_cast<float>(z) / flagstone_metres, Rgb{0.93f, 0.89f, 0.80f} * tone);
    };
    for (int z = -half; z < half; ++z)
        for (int x = -half; x < half; ++x) {
            const uint32_t a = corner(x, z + 1), b = corner(x + 1, z + 1), c = corner(x + 1, z), d = corner(x, z);
            ground_.triangle(a, b, c);
            ground_.triangle(a, c, d);
        }
}

void Forum::build_colonnade()
{
    constexpr int count = 40;
    constexpr Rgb marble = {0.94f, 0.90f, 0.83f};
    constexpr float low = 5.6f, high = 6.5f, half = 0.75f;
    const auto at = [](double turn, double radius, float y) {
        return Vec3{static_cast<float>(radius * std::sin(turn)), y, static_cast<float>(-radius * std::cos(turn))};
    };
    for (int i = 0; i < count; ++i) {
        const double turn = scenes::two_pi * i / count, next = scenes::two_pi * (i + 1) / count;
        const Vec3 foot = at(turn, radius_m, 0);
        stone_.turned(
            foot.x, foot.z,
            {{0.62f, 0}, {0.62f, 0.25f}, {0.45f, 0.4f}, {0.44f, 2.4f}, {0.38f, 5.1f}, {0.62f, 5.5f}, {0.62f, low}}, 14,
            marble);
        const double in = radius_m - half, out = radius_m + half;
        const Vec3 a = at(turn, in, low), b = at(next, in, low), c = at(next, out, low), d = at(turn, out, low);
        const Vec3 e = at(turn, in, high), f = at(next, in, high), g = at(next, out, high), h = at(turn, out, high);
        stone_.quad({a, b, f, e}, marble);
        stone_.quad({c, d, h, g}, marble * 0.95f);
        stone_.quad({d, c, b, a}, marble * 0.8f);
        stone_.quad({e, f, g, h}, marble);
    }
}

void Forum::draw(const Gl &g, const Eye &eye, Pictures &pictures, const std::vector<clq_transform> &people) const
{
    set_lights(g, light(), eye);
    g.Enable(gl::depth_test);
    pictures.flagstones_.use();
    ground_.draw(g);
    pictures.plaster_.use();
    stone_.draw(g);
    sky_.draw(g, eye);
    pictures.shadows_.cast(people, light().to_sun, person_height_m, shadow_width_m);
    pictures.shadows_.draw(g);
}

}  // namespace multichannel
