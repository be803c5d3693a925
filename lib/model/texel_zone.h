// The zone that a point of a texture shows, as the key test of drawing sees it: that of the nearest texel.
#pragma once

#include <cmath>

#include "lib/model/template.h"

namespace claque::model
{

inline uint32_t nearest_texel(double at, uint32_t size, Wrap wrap)
{
    const double within = wrap == Wrap::repeat ? at - std::floor(at) : std::fmin(std::fmax(at, 0), 1);
    return std::min(size - 1, static_cast<uint32_t>(within * size));
}

// The key of a zone, or 0 for a hole. `set`: index of Template::texture_sets, plus 1; 0: the texture's own image.
inline uint8_t texel_key(const Texture &texture, uint32_t set, double u, double v)
{
    const auto in = [&](const auto &image) {
        const uint32_t x = nearest_texel(u, image.width, texture.wrap_s),
                       y = nearest_texel(v, image.height, texture.wrap_t);
        return image.rgba[4 * (size_t(y) * image.width + x) + 3];
    };
    return set == 0 || texture.set_images.empty() ? in(texture) : in(texture.set_images[set - 1]);
}

// Index of Template::zones; none: a hole, or a texture without zones.
inline uint32_t texel_zone(const Texture &texture, uint32_t set, double u, double v)
{
    const uint8_t key = texel_key(texture, set, u, v);
    for (const ZoneKey &one : texture.keys)
        if (one.key == key) return one.zone;
    return none;
}

}  // namespace claque::model
