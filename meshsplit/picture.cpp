#include "meshsplit/picture.h"

#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>

#include "lib/math/hsb.h"

namespace claque::meshsplit
{

namespace
{

struct Ink {
    uint8_t r, g, b;
    double strength;
};

constexpr Ink clean_line = {90, 90, 90, 0.45};
constexpr Ink dirty_fill = {230, 20, 30, 0.30};
constexpr Ink dirty_line = {180, 0, 10, 0.95};

// Hues a golden section apart, so that zones with close numbers have distant colours, between yellow and violet: red is
// for dirty triangles.
math::Rgb8 zone_colour(size_t index)
{
    const double turns = 0.55 + 0.6180339887 * double(index);
    double rgb[3];
    math::hsb_to_rgb(50 + 230 * (turns - std::floor(turns)), index % 2 ? 0.38 : 0.20, index % 3 == 2 ? 0.84 : 0.97,
                     rgb);
    return math::rgb8_of(rgb);
}

class Picture
{
public:
    Picture(const model::Texture &texture, int scale)
        : texture_(texture), scale_(scale), width_(int(texture.width) * scale), height_(int(texture.height) * scale)
    {
        rgba_.resize(4 * size_t(width_) * size_t(height_), 255);
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) paint_zone(x, y);
    }

    void fill(const glm::dvec2 corners[3], const Ink &ink)
    {
        const double top = std::max({corners[0].y, corners[1].y, corners[2].y});
        const double bottom = std::min({corners[0].y, corners[1].y, corners[2].y});
        for (int y = int(std::ceil(bottom - 0.5)); y + 0.5 <= top; ++y) {
            double low = 1e30, high = -1e30;
            for (int k = 0; k < 3; ++k) {
                const glm::dvec2 a = corners[k], b = corners[(k + 1) % 3];
                if ((a.y <= y + 0.5) == (b.y <= y + 0.5)) continue;
                const double x = a.x + (b.x - a.x) * ((y + 0.5 - a.y) / (b.y - a.y));
                low = std::min(low, x), high = std::max(high, x);
            }
            for (int x = int(std::ceil(low - 0.5)); x + 0.5 <= high; ++x) blend(x, y, ink);
        }
    }

    void outline(const glm::dvec2 corners[3], const Ink &ink)
    {
        for (int k = 0; k < 3; ++k) line(corners[k], corners[(k + 1) % 3], ink);
    }

    glm::dvec2 place(const float *uv) const { return {double(uv[0]) * width_, double(uv[1]) * height_}; }
    double longest_side() const { return std::max(width_, height_); }
    std::vector<uint8_t> take() { return std::move(rgba_); }

private:
    void paint_zone(int x, int y)
    {
        const size_t texel = size_t(y / scale_) * texture_.width + size_t(x / scale_);
        const uint8_t key = texture_.rgba[4 * texel + 3];
        math::Rgb8 colour = (x / 4 + y / 4) % 2 ? math::Rgb8{200, 200, 200} : math::Rgb8{225, 225, 225};
        for (size_t i = 0; i < texture_.keys.size(); ++i)
            if (texture_.keys[i].key == key) colour = zone_colour(i);
        uint8_t *p = rgba_.data() + 4 * (size_t(y) * size_t(width_) + size_t(x));
        p[0] = colour.r, p[1] = colour.g, p[2] = colour.b;
    }

    void line(glm::dvec2 a, glm::dvec2 b, const Ink &ink)
    {
        const double steps = std::ceil(std::max({std::fabs(b.x - a.x), std::fabs(b.y - a.y), 1.0}));
        for (double i = 0; i < steps; ++i) {
            const glm::dvec2 p = a + (b - a) * (i / steps);
            blend(int(std::floor(p.x)), int(std::floor(p.y)), ink);
        }
    }

    void blend(int x, int y, const Ink &ink)
    {
        if (!wrap(x, width_, texture_.wrap_s) || !wrap(y, height_, texture_.wrap_t)) return;
        uint8_t *p = rgba_.data() + 4 * (size_t(y) * size_t(width_) + size_t(x));
        const uint8_t to[3] = {ink.r, ink.g, ink.b};
        for (int k = 0; k < 3; ++k) p[k] = uint8_t(std::lround(p[k] + (to[k] - p[k]) * ink.strength));
    }

    static bool wrap(int &i, int size, model::Wrap how)
    {
        if (how == model::Wrap::repeat) i = ((i % size) + size) % size;
        else i = i == size ? size - 1 : i;  // an edge at 1 belongs to the last texel
        return i >= 0 && i < size;
    }

    const model::Texture &texture_;
    const int scale_, width_, height_;
    std::vector<uint8_t> rgba_;
};

class Drawer
{
public:
    Drawer(const model::Level &level, Picture &picture) : level_(level), picture_(picture) {}

    template <class Draw>
    void each(const model::IndexRange &range, const Draw &draw) const
    {
        for (uint32_t i = range.first; i < range.first + range.count; i += 3) {
            glm::dvec2 corners[3];
            double size = 0;
            for (uint32_t k = 0; k < 3; ++k) {
                corners[k] = picture_.place(&level_.uvs[2 * size_t(level_.indices[i + k])]);
                size = std::max({size, std::fabs(corners[k].x), std::fabs(corners[k].y)});
            }
            // A triangle over many wraps covers everything, and its outline has no use.
            if (size <= 16 * picture_.longest_side()) draw(corners);
        }
    }

private:
    const model::Level &level_;
    Picture &picture_;
};

}  // namespace

std::vector<uint8_t> split_picture(const model::Template &tmpl, uint32_t texture, int scale)
{
    const model::Level &level = tmpl.levels[0];
    Picture picture(tmpl.textures[texture], scale);
    const Drawer drawer(level, picture);
    for (const model::Surface &surface : level.surfaces)
        if (surface.texture == texture)
            for (const model::Bin &bin : surface.clean)
                drawer.each(bin.range, [&](const glm::dvec2 *corners) { picture.outline(corners, clean_line); });
    for (const model::Surface &surface : level.surfaces)
        if (surface.texture == texture)
            drawer.each(surface.dirty, [&](const glm::dvec2 *corners) { picture.fill(corners, dirty_fill); });
    for (const model::Surface &surface : level.surfaces)
        if (surface.texture == texture)
            drawer.each(surface.dirty, [&](const glm::dvec2 *corners) { picture.outline(corners, dirty_line); });
    return picture.take();
}

}  // namespace claque::meshsplit
