#include "passes/close_image.h"

#include <algorithm>
#include <array>

#include "passes/colour_product.h"

namespace claque::passes
{

uint64_t close_bytes_of(uint32_t width, uint32_t height)
{
    uint64_t texels = 0;
    for (;; width = std::max(width / 2, 1u), height = std::max(height / 2, 1u)) {
        texels += uint64_t(width) * height;
        if (width == 1 && height == 1) return 4 * texels;
    }
}

void paint_close_image(const model::Texture &texture, const uint8_t *source, const CloseImage &image,
                       const uint8_t *rgb, uint8_t *out)
{
    std::array<const uint8_t *, 256> rgb_of;
    rgb_of.fill(rgb);
    for (size_t i = 0; i < texture.keys.size(); ++i) rgb_of[texture.keys[i].key] = rgb + 3 * i;
    for (size_t i = 0; i < image.sources.size(); ++i) {
        const uint8_t *texel = source + 4 * size_t(image.sources[i] & ~CloseImage::hole);
        const uint8_t *by = rgb_of[texel[3]];
        for (int c = 0; c < 3; ++c) out[4 * i + c] = product(texel[c], by[c]);
        out[4 * i + 3] = image.sources[i] & CloseImage::hole ? 0 : 255;
    }
}

void halve(uint8_t *rgba, uint32_t &width, uint32_t &height)
{
    const uint32_t w = std::max(width / 2, 1u), h = std::max(height / 2, 1u);
    for (uint32_t y = 0; y < h; ++y)
        for (uint32_t x = 0; x < w; ++x) {
            const size_t left = std::min(2 * x, width - 1), right = std::min(2 * x + 1, width - 1);
            const size_t low = size_t(std::min(2 * y, height - 1)) * width;
            const size_t high = size_t(std::min(2 * y + 1, height - 1)) * width;
            uint8_t mean[4];
            for (size_t c = 0; c < 4; ++c)
                mean[c] = static_cast<uint8_t>((rgba[4 * (low + left) + c] + rgba[4 * (low + right) + c] +
                                                rgba[4 * (high + left) + c] + rgba[4 * (high + right) + c] + 2) /
                                               4);
            std::copy(mean, mean + 4, rgba + 4 * (size_t(y) * w + x));
        }
    width = w, height = h;
}

}  // namespace claque::passes
