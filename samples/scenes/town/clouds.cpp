#include "samples/scenes/town/clouds.h"

#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/distance.h"
#include "samples/scenes/town/canvas.h"

namespace scenes::town
{
namespace
{

constexpr Rgb zenith = {0.25f, 0.47f, 0.78f}, middle = {0.46f, 0.66f, 0.88f};
constexpr int sides = 32;

Rgb sky_at(double height)  // the sine of the angle above the horizon
{
    const double t = std::sqrt(std::max(0.0, height));
    return t < 0.5 ? blend(Clouds::haze, middle, t / 0.5) : blend(middle, zenith, (t - 0.5) / 0.5);
}

// White where it is thick, grey below; alpha is the density.
Image cloud_picture(uint64_t seed)
{
    const RepeatingNoise a(seed + 400, 5, 5), b(seed + 401, 11, 11), c(seed + 402, 23, 23), d(seed + 403, 51, 51);
    const auto thick = [&](double u, double v) {
        return 0.50 * a(u, v) + 0.27 * b(u, v) + 0.15 * c(u, v) + 0.08 * d(u, v);
    };
    Image image = painted(512, [&](double u, double v) {
        const double shade = smooth_step((thick(u, v) - 0.56) / 0.24);
        return blend({1, 1, 1}, {0.80f, 0.83f, 0.88f}, shade);
    });
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) {
            const double cover = smooth_step((thick((x + 0.5) / 512, (y + 0.5) / 512) - 0.505) / 0.13);
            image.rgba[4 * static_cast<size_t>(y * 512 + x) + 3] = static_cast<uint8_t>(cover * 235 + 0.5);
        }
    return image;
}

}  // namespace

Clouds::Clouds(uint64_t seed) : seed_(seed)
{
    const double steps[] = {-0.999, -0.3, 0.0, 0.02, 0.05, 0.1, 0.17, 0.26, 0.38, 0.52, 0.68, 0.85, 0.9999};
    constexpr uint32_t wide = sides + 1;
    uint32_t row = 0;
    for (const double y : steps) {
        const double level = std::sqrt(1 - y * y);
        for (int side = 0; side <= sides; ++side) {
            const double turn = two_pi * side / sides, x = level * std::sin(turn), z = level * std::cos(turn);
            dome_.add({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}, {0, 1, 0}, 0, 0,
                      sky_at(y));
            // A layer above: towards the horizon it is farther away and fades into the haze.
            const double far = 0.34 / std::max(0.05, y + 0.03);
            layer_.add({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}, {0, 1, 0},
                       static_cast<float>(far * std::sin(turn) * level),
                       static_cast<float>(far * std::cos(turn) * level), {1, 1, 1},
                       static_cast<float>(smooth_step((y - 0.01) / 0.16)));
        }
        for (uint32_t side = 0; row > 0 && side < sides; ++side)
            for (Geometry *g : {&dome_, &layer_}) {
                if (g == &layer_ && y < 0.015) continue;
                const uint32_t a = (row - 1) * wide + side, b = row * wide + side;
                g->triangle(a, a + 1, b + 1);
                g->triangle(a, b + 1, b);
            }
        ++row;
    }
}

Image Clouds::picture() const { return cloud_picture(seed_); }

void Clouds::prepare(const Gl &gl)
{
    picture_ = std::make_unique<Texture>(gl, picture(), true, Texture::Filter::bilinear);
}

void Clouds::draw(const Gl &g, const Eye &eye) const
{
    begin_distance(g, eye, 100);  // between the near plane and the far one
    dome_.draw(g);
    if (picture_) {
        picture_->use();
        g.Enable(gl::blend);
        g.BlendFunc(gl::src_alpha, gl::one_minus_src_alpha);
        layer_.draw(g);
        g.Disable(gl::blend);
        g.Disable(gl::texture_2d);
    }
    end_distance(g, eye);
}

}  // namespace scenes::town
