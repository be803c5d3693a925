#include "samples/scenes/shadows.h"

#include <algorithm>
#include <cmath>

namespace scenes
{
namespace
{

// The picture: u [0, 0.5] is a person's shadow, feet at v = foot, head near v = 1; u [0.5, 1] is a round blot.
constexpr double foot = 0.16;
constexpr int side = 256;

double smooth(double t)
{
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// Half the width of a standing person at a fraction of the height, in units of the quad's half width.
double half_width(double h)
{
    constexpr double heights[] = {0.0, 0.06, 0.28, 0.36, 0.60, 0.78, 0.82, 0.86, 0.93, 0.98, 1.0};
    constexpr double widths[] = {0.30, 0.30, 0.33, 0.46, 0.46, 0.54, 0.34, 0.15, 0.22, 0.14, 0.0};
    if (h <= 0) return widths[0];
    for (int i = 1; i < 11; ++i)
        if (h <= heights[i]) {
            const double t = (h - heights[i - 1]) / (heights[i] - heights[i - 1]);
            return widths[i - 1] + (widths[i] - widths[i - 1]) * t;
        }
    return 0;
}

double person(double u, double v)  // u [-1, 1], v [0, 1]
{
    const double h = (v - foot) / (0.94 - foot);
    const double soft = 0.10 + 0.22 * std::max(h, 0.0);  // the sun is not a point
    double body = smooth((half_width(std::min(h, 1.0)) - std::abs(u)) / soft + 0.5);
    body *= smooth((h + 0.05) / 0.08) * smooth((1.04 - h) / 0.10) * (0.94 - 0.22 * std::max(h, 0.0));
    const double away = std::sqrt(u * u / 0.36 + (v - foot) * (v - foot) / (0.12 * 0.12));
    return std::max(body, 0.85 * smooth(1.15 - away));
}

Image person_and_blot()
{
    Image image;
    image.side_px = side;
    image.rgba.assign(4 * side * side, 0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double v = (y + 0.5) / side, u = (x + 0.5) / side;
            const double across = u < 0.5 ? u * 4 - 1 : u * 4 - 3;
            const double shade = u < 0.5 ? person(across, v)
                                         : smooth(1.25 * (1 - std::sqrt(across * across + (2 * v - 1) * (2 * v - 1))));
            image.rgba[4 * static_cast<size_t>(y * side + x) + 3] = static_cast<uint8_t>(shade * 255 + 0.5);
        }
    for (size_t i = 0; i < image.rgba.size(); i += 4) {  // white, so that the vertex colour sets the darkness
        image.rgba[i] = image.rgba[i + 1] = image.rgba[i + 2] = 255;
    }
    return image;
}

void start(const Gl &g)
{
    g.Disable(gl::lighting);
    g.Disable(gl::cull_face);
    g.Enable(gl::blend);
    g.BlendFunc(gl::src_alpha, gl::one_minus_src_alpha);
    g.DepthMask(0);
}

void finish(const Gl &g)
{
    g.DepthMask(1);
    g.Disable(gl::blend);
    g.Disable(gl::texture_2d);
    g.Enable(gl::lighting);
}

constexpr Rgb dark = {0.10f, 0.09f, 0.13f};
constexpr float lift = 0.012f;  // metres above the ground, to separate them in depth

}  // namespace

Image Shadows::picture() { return person_and_blot(); }

void Shadows::prepare(const Gl &gl) { image_.emplace(gl, picture(), false, Texture::Filter::bilinear); }

void Shadows::cast(const std::vector<clq_transform> &places, Vec3 to_sun, float height_m, float width_m)
{
    people_.clear();
    for (size_t i = 0; i < places.size(); ++i) lay(places, i, to_sun, height_m, width_m);
}

void Shadows::lay(const std::vector<clq_transform> &places, size_t i, Vec3 to_sun, float height_m, float width_m)
{
    const clq_transform &place = places[i];
    const float level = std::sqrt(to_sun.x * to_sun.x + to_sun.z * to_sun.z);
    const float dx = -to_sun.x / level, dz = -to_sun.z / level;  // away from the sun
    const float reach = place.scale * height_m * level / to_sun.y / static_cast<float>(0.94 - foot);
    const float back = reach * static_cast<float>(foot), half = place.scale * width_m * 0.5f;
    const float x = static_cast<float>(place.position[0]), z = static_cast<float>(place.position[2]);
    const float y = static_cast<float>(place.position[1]) + lift;
    const auto at = [&](float side_of, float along) {
        return Vec3{x + dx * along + dz * half * side_of, y, z + dz * along - dx * half * side_of};
    };
    const auto corner = [&](float side_of, float along, float u, float v) {
        return people_.add(at(side_of, along), {0, 1, 0}, u, v, dark, darkness);
    };
    const uint32_t a = corner(-1, -back, 0.004f, 0.002f), b = corner(1, -back, 0.496f, 0.002f);
    const uint32_t c = corner(1, reach - back, 0.496f, 0.998f), d = corner(-1, reach - back, 0.004f, 0.998f);
    people_.triangle(a, b, c);
    people_.triangle(a, c, d);
}

void Shadows::ring(Geometry &rims, float x, float y, float z, float half_x, float half_z)
{
    const auto corner = [&](float sx, float sz) {
        return rims.add({x + sx * half_x, y + lift * 0.5f, z + sz * half_z}, {0, 1, 0}, sx > 0 ? 0.996f : 0.504f,
                        sz > 0 ? 0.998f : 0.002f, dark, darkness);
    };
    const uint32_t a = corner(-1, 1), b = corner(1, 1), c = corner(1, -1), d = corner(-1, -1);
    rims.triangle(a, b, c);
    rims.triangle(a, c, d);
}

void Shadows::draw(const Gl &g, const Geometry &more) const
{
    if (!image_) return;
    image_->use();
    start(g);
    rims_.draw(g);
    more.draw(g);
    people_.draw(g);
    finish(g);
}

}  // namespace scenes
