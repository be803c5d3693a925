#include <cmath>
#include <string>

#include "growing_models.h"

namespace claque::testing
{

void add_node(model::Model &model, uint32_t parent)
{
    model.rig.parents.push_back(parent);
    model.rig.rest.emplace_back();
    model.rig.node_names.emplace_back(("n" + std::to_string(model.rig.node_count())).c_str());
}

model::Model net_of(uint32_t count)
{
    constexpr uint32_t image_px = 16;
    model::Model model;
    model.name = "net";
    for (uint32_t node = 0; node < 2; ++node) {
        add_node(model, node == 0 ? model::none : 0);
        model.rig.palette.push_back({node, math::Affine()});
        model.zones.emplace_back();
        model.zones[node].name = node == 0 ? "low" : "high", model.zones[node].key = static_cast<uint8_t>(128 * node);
    }
    model::Image &image = model.images.emplace_back();
    image.name = "zones", image.width = image.height = image_px, image.alpha = model::AlphaMeaning::zone_keys;
    for (uint32_t i = 0; i < image_px * image_px; ++i)
        image.rgba.insert(image.rgba.end(), {200, 200, 200, static_cast<uint8_t>(i % 16 < 7 ? 0 : 128)});
    model.materials.emplace_back();
    model.materials[0].image = 0;
    model.source_bytes = 1 << 26;  // what it may take in memory is not asked here
    model::Part &part = model.parts.emplace_back();
    part.material = 0, part.node = 0, part.skinned = true, part.influence_count = 2;
    const uint32_t columns = 10, rows = count / 20;
    for (uint32_t y = 0; y <= rows; ++y)
        for (uint32_t x = 0; x <= columns; ++x) {
            const glm::vec2 at(float(x) / float(columns), float(y) / float(rows));
            part.positions.emplace_back(at.x, at.y, 0.1f * std::sin(9 * at.x) * std::cos(7 * at.y));
            part.uvs.push_back(at);
            part.joints.insert(part.joints.end(), {0, 1});
            part.weights.insert(part.weights.end(), {1 - at.y, at.y});
            const uint32_t i = y * (columns + 1) + x;
            if (x == columns || y == rows) continue;
            for (const uint32_t corner : {i, i + 1, i + columns + 1, i + 1, i + columns + 2, i + columns + 1})
                part.indices.push_back(corner);
        }
    return model;
}

}  // namespace claque::testing
