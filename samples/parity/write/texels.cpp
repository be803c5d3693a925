#include "samples/parity/write/texels.h"

#include <png.h>

#include "samples/scenes/check.h"

namespace parity
{

using scenes::check;

Texels::Texels(const clq_template *tmpl, uint32_t texture, uint32_t texture_set)
{
    clq_texels texels = clq_texels_init();
    check(clq_template_get_texture(tmpl, texture_set, texture, &texels));
    width = texels.width_px, height = texels.height_px;
    const size_t count = static_cast<size_t>(width) * height;
    rgb.resize(3 * count);
    zones.resize(count);
    texels.rgb = rgb.data(), texels.zones = zones.data(), texels.capacity = count;
    check(clq_template_get_texture(tmpl, texture_set, texture, &texels));
    check(clq_template_get_wrap(tmpl, texture, &wrap_s, &wrap_t));
}

std::vector<uint8_t> png_of(const Texels &texels)
{
    std::vector<uint8_t> rgba;
    for (size_t i = 0; i < texels.zones.size(); ++i) {
        const uint32_t zone = texels.zones[i];
        if (zone != CLQ_NONE && zone > 254)
            throw scenes::Failure("a texture shows zone " + std::to_string(zone) +
                                  ", and a colour atlas has columns for 255");
        rgba.insert(rgba.end(), {texels.rgb[3 * i], texels.rgb[3 * i + 1], texels.rgb[3 * i + 2],
                                 static_cast<uint8_t>(zone == CLQ_NONE ? 0 : zone + 1)});
    }
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    image.width = texels.width;
    image.height = texels.height;
    image.format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = 0;
    std::vector<uint8_t> file;
    bool done = png_image_write_to_memory(&image, nullptr, &size, 0, rgba.data(), 0, nullptr) != 0;
    if (done) {
        file.resize(size);
        done = png_image_write_to_memory(&image, file.data(), &size, 0, rgba.data(), 0, nullptr) != 0;
        file.resize(size);
    }
    if (!done) throw scenes::Failure(std::string("libpng could not encode a texture: ") + image.message);
    return file;
}

}  // namespace parity
