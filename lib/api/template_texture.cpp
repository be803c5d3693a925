// The textures of a template, for hosts.
#include <claque/template_info.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "lib/api/boundary.h"
#include "lib/api/handles.h"

using namespace claque;

namespace
{

// An image of model::Texture, or of a texture set that replaces it.
template <class Image>
void read(const model::Texture &texture, const Image &from, const clq_texels &to)
{
    const size_t texels = static_cast<size_t>(from.width) * from.height;
    if ((to.rgb || to.zones) && to.capacity < texels)
        base::fail(CLQ_ARGUMENT, "room for %zu texels of a texture of %u x %u, which has %zu", to.capacity, from.width,
                   from.height, texels);
    std::array<uint32_t, 256> zone_of{};
    zone_of.fill(CLQ_NONE);
    for (const model::ZoneKey &key : texture.keys) zone_of[key.key] = key.zone;
    for (size_t i = 0; i < texels; ++i) {
        if (to.zones) to.zones[i] = zone_of[from.rgba[4 * i + 3]];
        if (to.rgb) std::copy_n(from.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 3, to.rgb + 3 * i);
    }
}

}  // namespace

extern "C" {

clq_status clq_template_get_texture(const clq_template *tmpl, uint32_t set, uint32_t texture, clq_texels *out)
{
    return api::boundary("clq_template_get_texture", [&] {
        api::require(tmpl && out, "tmpl or out is NULL");
        clq_texels texels = api::read_def(out, clq_texels_init, "clq_texels_init");
        if (texture >= tmpl->textures.size())
            base::fail(CLQ_ARGUMENT, "texture %u does not exist: '%s' has %zu", texture, tmpl->name.c_str(),
                       tmpl->textures.size());
        if (set >= tmpl->texture_set_count())
            base::fail(CLQ_ARGUMENT, "texture set %u does not exist: '%s' has %u", set, tmpl->name.c_str(),
                       tmpl->texture_set_count());
        const model::Texture &from = tmpl->textures[texture];
        const auto give = [&](const auto &image) {
            read(from, image, texels);
            texels.width_px = image.width, texels.height_px = image.height;
            api::write_out(out, texels);
        };
        if (set == 0 || from.set_images.empty()) give(from);
        else give(from.set_images[set - 1]);
    });
}

const char *clq_template_get_texture_set_name(const clq_template *tmpl, uint32_t set)
{
    return tmpl && set > 0 && set < tmpl->texture_set_count() ? tmpl->texture_sets[set - 1].c_str() : "";
}

uint32_t clq_template_find_texture_set(const clq_template *tmpl, const char *name)
{
    for (uint32_t set = 0; tmpl && name && set < tmpl->texture_set_count(); ++set)
        if (std::string_view(clq_template_get_texture_set_name(tmpl, set)) == name) return set;
    return CLQ_NONE;
}

}  // extern "C"
