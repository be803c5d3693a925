#include "passes/linear_footprint.h"

#include <cmath>

#include "passes/uv_row.h"

namespace claque::passes
{
namespace
{

constexpr double reach = 0.5 + snapping;  // GL_LINEAR reaches half a texel from a sample

}  // namespace

LinearFootprint::LinearFootprint(const model::Texture &texture) : texture_(texture)
{
    shown_.push_back({texture.width, texture.height, &texture.rgba});
    for (const model::TextureImage &other : texture.set_images)
        shown_.push_back({other.width, other.height, &other.rgba});
}

size_t LinearFootprint::texel(const Shown &shown, int64_t x, int64_t y) const
{
    const int64_t u = wrapped(x, shown.width, texture_.wrap_s), v = wrapped(y, shown.height, texture_.wrap_t);
    return 4 * (static_cast<size_t>(v) * shown.width + static_cast<size_t>(u));
}

bool LinearFootprint::row_has_one_zone(const Shown &shown, int64_t row, double low, double high, int &key) const
{
    for (int64_t x = static_cast<int64_t>(std::floor(low - reach)); x <= static_cast<int64_t>(std::floor(high + reach));
         ++x) {
        const int here = (*shown.rgba)[texel(shown, x, row) + 3];
        if (here == 0 || (key >= 0 && here != key)) return false;
        key = here;
    }
    return true;
}

bool LinearFootprint::one_zone(const Shown &shown, const glm::vec2 (&uv)[3], int &key) const
{
    double x[3], y[3];
    for (int k = 0; k < 3; ++k) {
        x[k] = double(uv[k].x) * shown.width, y[k] = double(uv[k].y) * shown.height;
        if (!(std::fabs(x[k]) < max_texels_across && std::fabs(y[k]) < max_texels_across)) return false;
    }
    const auto [minimum, maximum] = std::minmax({y[0], y[1], y[2]});
    for (int64_t row = static_cast<int64_t>(std::floor(minimum - reach));
         row <= static_cast<int64_t>(std::floor(maximum + reach)); ++row) {
        double low = 1e30, high = -1e30;
        widen(x, y, double(row) - reach, double(row + 1) + reach, low, high);
        if (low <= high && !row_has_one_zone(shown, row, low, high, key)) return false;
    }
    return true;
}

bool LinearFootprint::has_one_zone(const glm::vec2 (&uv)[3]) const
{
    int key = -1;
    return std::all_of(shown_.begin(), shown_.end(), [&](const Shown &shown) { return one_zone(shown, uv, key); });
}

double LinearFootprint::luminance(const Shown &shown, int64_t x, int64_t y) const
{
    const uint8_t *rgb = shown.rgba->data() + texel(shown, x, y);
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

double LinearFootprint::nearest(glm::vec2 uv) const
{
    const Shown &shown = shown_[0];
    return luminance(shown, static_cast<int64_t>(std::floor(double(uv.x) * shown.width)),
                     static_cast<int64_t>(std::floor(double(uv.y) * shown.height)));
}

double LinearFootprint::linear(glm::vec2 uv) const
{
    const Shown &shown = shown_[0];
    const double x = double(uv.x) * shown.width - 0.5, y = double(uv.y) * shown.height - 0.5;
    const int64_t i = static_cast<int64_t>(std::floor(x)), j = static_cast<int64_t>(std::floor(y));
    const double a = x - double(i), b = y - double(j);
    return (1 - b) * ((1 - a) * luminance(shown, i, j) + a * luminance(shown, i + 1, j)) +
           b * ((1 - a) * luminance(shown, i, j + 1) + a * luminance(shown, i + 1, j + 1));
}

}  // namespace claque::passes
