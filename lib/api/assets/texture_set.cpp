// Adds a texture set to an asset.
#include <claque/assets.h>

#include "lib/api/assets/asset_handle.h"
#include "lib/api/image_def.h"

using namespace claque;

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
                if (images[i].rgba)
                    model.images.push_back(api::image_of(images[i], base::text_of("the image for material %u", i)));
            }
            model.texture_sets.push_back(std::move(set));
            try {
                model::check_texture_sets(model);
            } catch (...) {
                model.texture_sets.pop_back();
                throw;
            }
            for (size_t i = images_before; i < model.images.size() && model.source_bytes; ++i)
                model.source_bytes += model.images[i].rgba.size();
        } catch (...) {
            model.images.resize(images_before);
            throw;
        }
    });
}
