#include "lib/asset/material_zones.h"

#include <map>

#include "lib/asset/zone_ranges.h"

namespace claque::asset
{

void add_material_zones(const std::vector<bool> &used, model::Model &model)
{
    std::map<std::pair<std::string, std::array<float, 3>>, uint32_t> made;
    for (size_t i = 0; i < model.materials.size(); ++i) {
        model::Material &material = model.materials[i];
        const bool has_image = material.image != model::none;
        if (!used[i] || (has_image && model.images[material.image].alpha == model::AlphaMeaning::zone_keys)) continue;
        const std::array<float, 3> colour = {material.base_colour[0], material.base_colour[1], material.base_colour[2]};
        if (material.zone != model::none) continue;
        const uint32_t next = static_cast<uint32_t>(model.zones.size());
        const auto [place, is_new] = made.emplace(std::make_pair(material.name, colour), next);
        material.zone = place->second;
        if (!is_new) continue;
        model::Zone zone;
        zone.name = material.name;
        zone.colour = colour;
        zone.range = default_range(material.name, colour, has_image ? Texturing::textured : Texturing::untextured);
        model.zones.push_back(zone);
    }
}

}  // namespace claque::asset
