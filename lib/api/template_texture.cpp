// What a texture of a template shows.
#include <claque/template.h>

#include <algorithm>
#include <array>

#include "lib/api/boundary.h"
#include "lib/api/handles.h"

using namespace claque;

extern "C" {

clq_status clq_template_get_texture(const clq_template *tmpl, uint32_t texture, uint8_t *out_rgb, uint32_t *out_zones,
                                    size_t capacity_texels, uint32_t *out_width_px, uint32_t *out_height_px)
{
    return api::boundary("clq_template_get_texture", [&] {
        api::require(tmpl && out_width_px && out_height_px, "tmpl, out_width_px or out_height_px is NULL");
        if (texture >= tmpl->textures.size())
            base::fail(CLQ_ARGUMENT, "texture %u of '%s', which has %zu", texture, tmpl->name.c_str(),
                       tmpl->textures.size());
        const model::Texture &from = tmpl->textures[texture];
        const size_t texels = static_cast<size_t>(from.width) * from.height;
        if ((out_rgb || out_zones) && capacity_texels < texels)
            base::fail(CLQ_ARGUMENT, "room for %zu texels of a texture of %u x %u, which has %zu", capacity_texels,
                       from.width, from.height, texels);
        std::array<uint32_t, 256> zone_of{};
        zone_of.fill(CLQ_NONE);
        for (const model::ZoneKey &key : from.keys) zone_of[key.key] = key.zone;
        for (size_t i = 0; i < texels; ++i) {
            if (out_zones) out_zones[i] = zone_of[from.rgba[4 * i + 3]];
            if (out_rgb) std::copy_n(from.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 3, out_rgb + 3 * i);
        }
        *out_width_px = from.width;
        *out_height_px = from.height;
    });
}

}  // extern "C"
