#include "tests/gl/support/uploads.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace gltest
{
namespace
{

// The content of a texture in one set.
struct Shown {
    uint32_t width, height;
    const model::Array<uint8_t> *rgba;
};

Shown shown_by(const model::Texture &texture, uint32_t set)
{
    if (set == 0 || texture.set_images.empty()) return {texture.width, texture.height, &texture.rgba};
    const model::TextureImage &other = texture.set_images[set - 1];
    return {other.width, other.height, &other.rgba};
}

// Each texel in its zone's colour; alpha 0 in holes.
std::vector<uint8_t> coloured_texels(const model::Texture &texture, const Shown &shown, const uint8_t *zone_rgb)
{
    std::vector<uint8_t> out(shown.rgba->begin(), shown.rgba->end());
    for (size_t i = 0; i < out.size(); i += 4) {
        const uint8_t key = out[i + 3];
        const auto zone = std::find_if(texture.keys.begin(), texture.keys.end(),
                                       [&](const model::ZoneKey &k) { return k.key == key; });
        const bool is_hole = texture.has_holes && zone == texture.keys.end();
        if (!is_hole && zone == texture.keys.end()) {
            ADD_FAILURE() << "a texel's alpha " << int(key) << " is no key of its texture";
            return out;
        }
        if (!is_hole) std::copy_n(zone_rgb + 3 * zone->zone, 3, &out[i]);
        out[i + 3] = is_hole ? 0 : 255;
    }
    return out;
}

// Left bound; the caller deletes it.
uint32_t upload(const HostGl &host, const model::Texture &texture, const Shown &shown, const std::vector<uint8_t> &rgba)
{
    uint32_t name = 0;
    host.GenTextures(1, &name);
    host.BindTexture(gl::texture_2d, name);
    const auto wrap = [](model::Wrap w) { return int32_t(w == model::Wrap::clamp ? gl::clamp : gl::repeat); };
    host.TexParameteri(gl::texture_2d, gl::texture_min_filter, int32_t(gl::nearest));
    host.TexParameteri(gl::texture_2d, gl::texture_mag_filter, int32_t(gl::nearest));
    host.TexParameteri(gl::texture_2d, gl::wrap_s, wrap(texture.wrap_s));
    host.TexParameteri(gl::texture_2d, gl::wrap_t, wrap(texture.wrap_t));
    host.TexImage2D(gl::texture_2d, 0, int32_t(gl::rgba8), int32_t(shown.width), int32_t(shown.height), 0, gl::rgba,
                    gl::unsigned_byte, rgba.data());
    return name;
}

}  // namespace

Uploads::~Uploads()
{
    for (const auto &[key, name] : names_) host_.DeleteTextures(1, &name);
}

uint32_t Uploads::of(const model::Texture &texture, uint32_t set, const uint8_t *zone_rgb)
{
    const auto [at, fresh] = names_.try_emplace({&texture, set, zone_rgb}, 0);
    const Shown shown = shown_by(texture, set);
    if (fresh) at->second = upload(host_, texture, shown, coloured_texels(texture, shown, zone_rgb));
    return at->second;
}

}  // namespace gltest
