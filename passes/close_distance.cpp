#include "passes/close_distance.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "passes/close_image.h"
#include "passes/close_samples.h"
#include "passes/uv_row.h"

namespace claque::passes
{
namespace
{

constexpr double target = 2;                                             // of 255
constexpr float nearest_m = 0.5f, farthest_m = 64, step = 1.189207115f;  // four steps double a distance
constexpr double lines_per_tangent = 384 * 1.7320508075688772;

// log2 to 20 bits, alike on all processors, which glibc does not promise.
double binary_logarithm(double x)
{
    int exponent = 0;
    double mantissa = 2 * std::frexp(x, &exponent), bits = 0;
    for (double bit = 0.5; bit > 1e-6; bit /= 2) {
        mantissa *= mantissa;
        if (mantissa < 2) continue;
        mantissa /= 2;
        bits += bit;
    }
    return exponent - 1 + bits;
}

// The mip chain of a texture in the template's own colours.
class Chain
{
public:
    Chain(const model::Texture &texture, const PreparedTexture &ready, const Array<uint8_t> &zone_rgb)
        : wrap_s_(texture.wrap_s), wrap_t_(texture.wrap_t)
    {
        std::vector<uint8_t> rgb;
        for (const ZoneTest &test : ready.tests)
            rgb.insert(rgb.end(), &zone_rgb[3 * size_t(test.zone)], &zone_rgb[3 * size_t(test.zone)] + 3);
        uint32_t width = ready.close[0].width, height = ready.close[0].height;
        std::vector<uint8_t> pixels(size_t(4) * width * height);
        paint_close_image(texture, texture.rgba.data(), ready.close[0], rgb.data(), pixels.data());
        for (;;) {
            levels_.push_back({width, height, {pixels.begin(), pixels.begin() + 4 * std::ptrdiff_t(width * height)}});
            if (width == 1 && height == 1) return;
            halve(pixels.data(), width, height);
        }
    }

    // The mean of the three channels' differences at a point; `texels` of level 0 fall on a pixel.
    double difference(glm::dvec2 uv, double texels) const
    {
        const double lambda = std::clamp(binary_logarithm(std::max(texels, 1e-6)), 0.0, double(levels_.size() - 1));
        const size_t low = static_cast<size_t>(lambda), high = std::min(low + 1, levels_.size() - 1);
        const glm::dvec3 a = linear(levels_[low], uv), b = linear(levels_[high], uv);
        const Image &first = levels_[0];
        const glm::dvec3 nearest = texel(first, std::floor(uv.x * first.width), std::floor(uv.y * first.height));
        const glm::dvec3 apart = glm::abs(a + (lambda - double(low)) * (b - a) - nearest);
        return (apart.x + apart.y + apart.z) / 3;
    }

private:
    struct Image {
        uint32_t width, height;
        std::vector<uint8_t> rgba;
    };
    // Texture coordinates of a file may be any finite number; beyond this, doubles have no fractions left.
    static int64_t whole(double value) { return std::fabs(value) < 4e15 ? static_cast<int64_t>(value) : 0; }
    glm::dvec3 texel(const Image &image, double x, double y) const
    {
        const size_t s = size_t(wrapped(whole(x), image.width, wrap_s_));
        const size_t t = size_t(wrapped(whole(y), image.height, wrap_t_));
        const uint8_t *at = &image.rgba[4 * (t * image.width + s)];
        return {at[0], at[1], at[2]};
    }
    glm::dvec3 linear(const Image &image, glm::dvec2 uv) const
    {
        const double x = uv.x * image.width - 0.5, y = uv.y * image.height - 0.5;
        const double i = std::floor(x), j = std::floor(y), s = x - i, t = y - j;
        return (1 - t) * ((1 - s) * texel(image, i, j) + s * texel(image, i + 1, j)) +
               t * ((1 - s) * texel(image, i, j + 1) + s * texel(image, i + 1, j + 1));
    }

    model::Wrap wrap_s_, wrap_t_;
    std::vector<Image> levels_;
};

class Measure
{
public:
    explicit Measure(const PreparedTemplate &prepared) : prepared_(prepared), samples_(prepared.levels.size())
    {
        for (size_t i = 0; i < prepared.textures.size(); ++i) {
            const bool shown = !prepared.textures[i].close.empty();
            chains_.emplace_back();
            if (shown)
                chains_.back().emplace_back(prepared.source->textures[i], prepared.textures[i], prepared.zone_rgb);
        }
    }

    double difference(uint32_t level, float distance_m)
    {
        if (samples_[level].empty()) samples_[level] = close_samples(prepared_.source->levels[level]);
        const double metres = double(distance_m) / lines_per_tangent;  // on the surface, per pixel
        double sum = 0;
        for (const CloseSample &sample : samples_[level]) {
            const model::Texture &texture = prepared_.source->textures[sample.texture];
            const glm::dvec2 size(texture.width, texture.height);
            const double texels = std::max(glm::length(sample.across * size), glm::length(sample.up * size)) * metres;
            sum += chains_[sample.texture][0].difference(sample.uv, texels);
        }
        return samples_[level].empty() ? 0 : sum / double(samples_[level].size());
    }

private:
    const PreparedTemplate &prepared_;
    std::vector<std::vector<Chain>> chains_;  // one or none per texture
    std::vector<std::vector<CloseSample>> samples_;
};

// The level that serves at a distance.
uint32_t level_at(const model::Template &tmpl, float distance_m)
{
    uint32_t level = 0;
    while (level + 1 < tmpl.levels.size() && tmpl.levels[level + 1].switch_distance_m <= distance_m) ++level;
    return level;
}

}  // namespace

float close_difference(const PreparedTemplate &prepared, uint32_t level, float distance_m)
{
    if (!prepared.levels[level].shows_close) return 0;
    return static_cast<float>(Measure(prepared).difference(level, distance_m));
}

float close_distance(const PreparedTemplate &prepared)
{
    Measure measure(prepared);
    double least = HUGE_VAL, before = HUGE_VAL;
    float least_at = 0, below_at = 0;
    for (float at = nearest_m; at <= farthest_m; at *= step) {
        const uint32_t level = level_at(*prepared.source, at);
        if (!prepared.levels[level].shows_close) break;
        const double here = measure.difference(level, at);
        if (here < least) least = here, least_at = at;
        if (here < target) below_at = at;
        else if (before < target)
            below_at = at / step + static_cast<float>((target - before) / (here - before)) * (at - at / step);
        before = here;
    }
    return least < target ? below_at : least_at;
}

}  // namespace claque::passes
