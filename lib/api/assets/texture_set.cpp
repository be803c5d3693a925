#include <claque/assets.h>

#include "lib/api/assets/asset_handle.h"
#include "lib/api/boundary.h"

using namespace claque;

namespace
{

model::Image image_of(const clq_image_def &def, uint32_t material)
{
    if (def.width_px < 1 || def.width_px > 16384 || def.height_px < 1 || def.height_px > 16384)
        base::fail(CLQ_ARGUMENT, "the image for material %u is %u x %u pixels: 1 to 16384 are wanted", material,
                   def.width_px, def.height_px);
    if (api::number_of(def.alpha) > 1)
        base::fail(CLQ_ARGUMENT, "the image for material %u has an alpha meaning that is none", material);
    model::Image image;
    image.name = api::name_of(def.name);
    image.width = def.width_px, image.height = def.height_px;
    image.rgba.assign(def.rgba, def.rgba + 4ull * def.width_px * def.height_px);
    image.alpha = def.alpha == CLQ_ALPHA_ZONE_KEYS ? model::AlphaMeaning::zone_keys : model::AlphaMeaning::opacity;
    return image;
}

}  // namespace

extern "C" clq_status clq_asset_add_texture_set(clq_context *context, clq_asset *asset, const char *name,
                                                const clq_image_def *images, uint32_t image_count)
{
    return api::boundary("clq_asset_add_texture_set", [&] {
        api::require(context && asset && name, "context, asset or name is NULL");
        api::require_array(images, image_count, "images");
        model::Model &model = asset->model;
        if (image_count != model.materials.size())
            base::fail(CLQ_ARGUMENT, "%u images for '%s', which has %zu materials", image_count, model.name.c_str(),
                       model.materials.size());
        const size_t images_before = model.images.size();
        try {
            model::TextureSet set;
            set.name = name;
            for (uint32_t i = 0; i < image_count; ++i) {
                set.images.push_back(images[i].rgba ? static_cast<uint32_t>(model.images.size()) : model::none);
                if (images[i].rgba) model.images.push_back(image_of(images[i], i));
            }
            model.texture_sets.push_back(std::move(set));
            try {
                model::check_texture_sets(model);
            } catch (...) {
                model.texture_sets.pop_back();
                throw;
            }
        } catch (...) {
            model.images.resize(images_before);
            throw;
        }
    });
}
