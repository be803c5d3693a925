#include "samples/scenes/odeon/orchestra.h"

#include <algorithm>
#include <cmath>

#include "samples/scenes/angles.h"
#include "samples/scenes/odeon/opus_sectile.h"

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

}  // namespace

Orchestra::Orchestra(const Theatre &theatre, uint64_t seed) : seed_(seed)
{
    const double reach = theatre.orchestra_radius_m + under_podium_m;
    panels_ = std::max(3, static_cast<int>(2 * reach / panel_m) | 1);
    const auto point = [&](double part, int side, double shade) {
        const double x = part * std::sin(two_pi * side / sides), z = part * std::cos(two_pi * side / sides);
        const float light = static_cast<float>(shade);
        return floor_.add({static_cast<float>(x * reach), 0, static_cast<float>(z * reach)}, {0, 1, 0},
                          static_cast<float>(0.5 + 0.5 * x), static_cast<float>(0.5 + 0.5 * z), {light, light, light});
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

void Orchestra::prepare(const Gl &gl) { image_.emplace(gl, opus_sectile(seed_, panels_), false); }

void Orchestra::draw(const Gl &g) const
{
    if (!image_) return;
    image_->use();
    g.Disable(gl::depth_test);
    floor_.draw(g);
    g.Enable(gl::depth_test);
}

}  // namespace scenes
