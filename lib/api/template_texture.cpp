// What a texture of a template shows.
#include <claque/template.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "lib/api/boundary.h"
#include "lib/api/handles.h"

using namespace claque;

namespace
{

// Of model::Texture, or what it shows of another set.
template <class Image>
void read(const model::Texture &texture, const Image &from, uint8_t *out_rgb, uint32_t *out_zones,
          size_t capacity_texels)
{
    const size_t texels = static_cast<size_t>(from.width) * from.height;
    if ((out_rgb || out_zones) && capacity_texels < texels)
        base::fail(CLQ_ARGUMENT, "room for %zu texels of a texture of %u x %u, which has %zu", capacity_texels,
                   from.width, from.height, texels);
    std::array<uint32_t, 256> zone_of{};
    zone_of.fill(CLQ_NONE);
    for (const model::ZoneKey &key : texture.keys) zone_of[key.key] = key.zone;
    for (size_t i = 0; i < texels; ++i) {
        if (out_zones) out_zones[i] = zone_of[from.rgba[4 * i + 3]];
        if (out_rgb) std::copy_n(from.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 3, out_rgb + 3 * i);
    }
}

}  // namespace

extern "C" {

clq_status clq_template_get_texture(const clq_template *tmpl, uint32_t texture, uint8_t *out_rgb, uint32_t *out_zones,
                                    size_t capacity_texels, uint32_t *out_width_px, uint32_t *out_height_px)
{
    return clq_template_get_set_texture(tmpl, 0, texture, out_rgb, out_zones, capacity_texels, out_width_px,
                                        out_height_px);
}

clq_status clq_template_get_set_texture(const clq_template *tmpl, uint32_t set, uint32_t texture, uint8_t *out_rgb,
                                        uint32_t *out_zones, size_t capacity_texels, uint32_t *out_width_px,
                                        uint32_t *out_height_px)
{
    return api::boundary("clq_template_get_texture", [&] {
        api::require(tmpl && out_width_px && out_height_px, "tmpl, out_width_px or out_height_px is NULL");
        if (texture >= tmpl->textures.size())
            base::fail(CLQ_ARGUMENT, "texture %u of '%s', which has %zu", texture, tmpl->name.c_str(),
                       tmpl->textures.size());
        if (set >= tmpl->texture_set_count())
            base::fail(CLQ_ARGUMENT, "texture set %u of '%s', which has %u", set, tmpl->name.c_str(),
                       tmpl->texture_set_count());
        const model::Texture &from = tmpl->textures[texture];
        const auto give = [&](const auto &image) {
            read(from, image, out_rgb, out_zones, capacity_texels);
            *out_width_px = image.width;
            *out_height_px = image.height;
        };
        if (set == 0 || from.set_images.empty()) give(from);
        else give(from.set_images[set - 1]);
    });
}

const char *clq_template_texture_set_name(const clq_template *tmpl, uint32_t set)
{
    return tmpl && set > 0 && set < tmpl->texture_set_count() ? tmpl->texture_sets[set - 1].c_str() : "";
}

uint32_t clq_template_find_texture_set(const clq_template *tmpl, const char *name)
{
    for (uint32_t set = 0; tmpl && name && set < tmpl->texture_set_count(); ++set)
        if (std::string_view(clq_template_texture_set_name(tmpl, set)) == name) return set;
    return CLQ_NONE;
}

}  // extern "C"
