#include "lib/asset/material_zones.h"

#include "lib/asset/zone_ranges.h"

namespace claque::asset
{

void add_material_zones(const std::vector<bool> &used, model::Model &model)
{
    const size_t keyed = model.zones.size();
    for (size_t i = 0; i < model.materials.size(); ++i) {
        model::Material &material = model.materials[i];
        const bool has_image = material.image != model::none;
        if (!used[i] || (has_image && model.images[material.image].alpha == model::AlphaMeaning::zone_keys)) continue;
        const std::array<float, 3> colour = {material.base_colour[0], material.base_colour[1], material.base_colour[2]};
        for (size_t z = keyed; z < model.zones.size() && material.zone == model::none; ++z)
            if (model.zones[z].name == material.name && model.zones[z].colour == colour)
                material.zone = static_cast<uint32_t>(z);
        if (material.zone != model::none) continue;
        model::Zone zone;
        zone.name = material.name;
        zone.colour = colour;
        zone.range = default_range(material.name, colour, has_image ? Texturing::textured : Texturing::untextured);
        material.zone = static_cast<uint32_t>(model.zones.size());
        model.zones.push_back(zone);
    }
}

}  // namespace claque::asset
