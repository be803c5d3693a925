#include "passes/smooth_levels.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "passes/close_cover.h"
#include "passes/close_samples.h"

namespace claque::passes
{
namespace
{

constexpr double lines_a_tangent = 384 * 1.7320508075688772;  // a picture of 768 lines over 60 degrees
constexpr double next_step = 1.4142135623730951;              // texels; half a step, as for GL_NEAREST_MIPMAP_NEAREST

// How far the texels that a step adds are away. The image before has means already, so three each way are enough; the
// variances of all steps up to one add up to about that of a square of 2^step texels.
constexpr int64_t reaches[max_smooth_step + 1] = {0, 1, 1, 3, 6};

// Half of a level's pixels show at least so many texels of the texture, for each metre of distance.
double texels_a_metre(const std::vector<CloseSample> &samples, uint32_t texture, glm::dvec2 size)
{
    std::vector<double> texels;
    for (const CloseSample &sample : samples)
        if (sample.texture == texture)
            texels.push_back(std::max(glm::length(sample.across * size), glm::length(sample.up * size)));
    if (texels.empty()) return 0;
    const auto middle = texels.begin() + std::ptrdiff_t(texels.size() / 2);
    std::nth_element(texels.begin(), middle, texels.end());
    return *middle / lines_a_tangent;
}

uint32_t step_for(double texels)
{
    uint32_t step = 0;
    for (; texels >= next_step && step < max_smooth_step; texels /= 2) ++step;
    return step;
}

glm::vec2 at_corner(const model::Level &level, uint32_t index)
{
    const size_t vertex = level.indices[index];
    return {level.uvs[2 * vertex], level.uvs[2 * vertex + 1]};
}

void add_level(CloseCover &cover, const model::Level &level, uint32_t texture)
{
    const auto add = [&](model::IndexRange range) {
        for (uint32_t i = range.first; i < range.first + range.count; i += 3)
            cover.add({at_corner(level, i), at_corner(level, i + 1), at_corner(level, i + 2)});
    };
    for (const model::Surface &surface : level.surfaces) {
        if (surface.texture != texture) continue;
        for (const model::Bin &bin : surface.clean) add(bin.range);
        add(surface.dirty);
    }
}

}  // namespace

void prepare_smooth(PreparedTemplate &out)
{
    const model::Template &source = *out.source;
    for (size_t i = 1; i < out.levels.size(); ++i) {
        const model::Level &level = source.levels[i];
        const std::vector<CloseSample> samples = close_samples(level);
        for (const model::Surface &surface : out.levels[i].drawn(level).surfaces) {
            const model::Texture &texture = source.textures[surface.texture];
            const uint32_t step = step_for(texels_a_metre(samples, surface.texture, {texture.width, texture.height}) *
                                           double(level.switch_distance_m));
            out.levels[i].smooth.push_back(static_cast<uint8_t>(step));
            uint32_t &steps = out.textures[surface.texture].smooth_steps;
            steps = std::max(steps, step);
        }
    }
    for (PreparedTexture &texture : out.textures)
        texture.names.resize(texture.names.size() * (1 + texture.smooth_steps));
}

std::vector<uint8_t> shown_texels(const model::Template &source, uint32_t texture, uint32_t width, uint32_t height)
{
    const model::Texture &wraps = source.textures[texture];
    CloseCover cover(width, height, wraps.wrap_s, wraps.wrap_t, std::pmr::get_default_resource());
    for (const model::Level &level : source.levels) add_level(cover, level, texture);
    std::vector<uint8_t> shown(size_t(width) * height);
    for (size_t i = 0; i < shown.size(); ++i) shown[i] = cover.shows(i);
    return shown;
}

std::vector<uint8_t> smooth_image(const model::Texture &texture, const std::vector<uint8_t> &rgba, uint32_t width,
                                  uint32_t height, const std::vector<uint8_t> &shown, uint32_t step)
{
    std::vector<uint8_t> out(rgba);
    const int64_t reach = reaches[step];
    std::vector<size_t> columns;  // of each texel: to its left, its own, to its right
    for (int64_t x = 0; x < width; ++x)
        for (const int64_t u : {-reach, int64_t(0), reach})
            columns.push_back(static_cast<size_t>(wrapped(x + u, width, texture.wrap_s)));
    for (int64_t y = 0; y < height; ++y) {
        size_t rows[3];
        for (int64_t k = 0; k < 3; ++k)
            rows[k] = static_cast<size_t>(wrapped(y + (k - 1) * reach, height, texture.wrap_t)) * width;
        for (size_t x = 0; x < width; ++x) {
            const size_t here = rows[1] + x;
            if (!shown[here]) continue;
            uint32_t sum[3] = {0, 0, 0}, weights = 0;
            for (size_t v = 0; v < 3; ++v)
                for (size_t u = 0; u < 3; ++u) {
                    const size_t at = rows[v] + columns[3 * x + u];
                    if (!shown[at] || rgba[4 * at + 3] != rgba[4 * here + 3]) continue;
                    const uint32_t weight = (u == 1 ? 2u : 1u) * (v == 1 ? 2u : 1u);
                    for (size_t c = 0; c < 3; ++c) sum[c] += weight * rgba[4 * at + c];
                    weights += weight;
                }
            for (size_t c = 0; c < 3; ++c) out[4 * here + c] = static_cast<uint8_t>((sum[c] + weights / 2) / weights);
        }
    }
    return out;
}

}  // namespace claque::passes
