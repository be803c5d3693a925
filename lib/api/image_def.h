// Converts a host's image to a Model's, for templates and for texture sets of assets.
#pragma once

#include <claque/template.h>

#include <string>

#include "lib/api/boundary.h"
#include "lib/model/model.h"

namespace claque::api
{

// `def.rgba` is not NULL; `what` names the image. Throws base::Error (CLQ_ARGUMENT).
inline model::Image image_of(const clq_image_def &def, const std::string &what)
{
    if (!model::is_image_size(def.width_px, def.height_px))
        base::fail(CLQ_ARGUMENT, "%s is %u x %u pixels: 1 to %u are wanted", what.c_str(), def.width_px, def.height_px,
                   model::max_image_px);
    if (number_of(def.alpha) > 1) base::fail(CLQ_ARGUMENT, "%s has an unknown meaning of alpha", what.c_str());
    model::Image image;
    image.name = name_of(def.name);
    image.width = def.width_px, image.height = def.height_px;
    image.rgba.assign(def.rgba, def.rgba + 4ull * def.width_px * def.height_px);
    image.alpha = def.alpha == CLQ_ALPHA_ZONE_KEYS ? model::AlphaMeaning::zone_keys : model::AlphaMeaning::opacity;
    return image;
}

}  // namespace claque::api
