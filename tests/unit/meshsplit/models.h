// Characters made by code for the splitter's tests.
#pragma once

#include <functional>
#include <memory>

#include "lib/model/model.h"
#include "meshsplit/build.h"

namespace claque::test
{

using KeyAt = std::function<uint8_t(uint32_t x, uint32_t y)>;

inline model::Image key_image(uint32_t width, uint32_t height, const KeyAt &key)
{
    model::Image image;
    image.name = "zones";
    image.width = width, image.height = height;
    image.alpha = model::AlphaMeaning::zone_keys;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const uint8_t k = key(x, y);
            image.rgba.insert(image.rgba.end(), {uint8_t(40 + k % 100), uint8_t(x * 7), uint8_t(y * 5), k});
        }
    return image;
}

// One node, one palette entry, no geometry.
inline model::Model empty_model()
{
    model::Model m;
    m.name = "sheet";
    m.rig.parents.push_back(model::none);
    m.rig.rest.push_back(math::Trs());
    m.rig.node_names.emplace_back("root");
    m.rig.palette.push_back({0, math::Affine()});
    return m;
}

// A flat grid of 2 * columns * rows triangles whose UVs go from `low` to `high`; all on palette entry 0.
inline model::Part sheet_part(uint32_t columns, uint32_t rows, glm::vec2 low = glm::vec2(0),
                              glm::vec2 high = glm::vec2(1))
{
    model::Part part;
    part.name = "sheet";
    part.node = 0;
    part.material = 0;
    for (uint32_t y = 0; y <= rows; ++y)
        for (uint32_t x = 0; x <= columns; ++x) {
            const glm::vec2 f(float(x) / float(columns), float(y) / float(rows));
            part.positions.emplace_back(f.x, f.y, 0);
            part.normals.emplace_back(0, 0, 1);
            part.uvs.push_back(low + f * (high - low));
            part.joints.push_back(0);
            part.weights.push_back(1);
        }
    for (uint32_t y = 0; y < rows; ++y)
        for (uint32_t x = 0; x < columns; ++x) {
            const uint32_t a = y * (columns + 1) + x, b = a + 1, c = a + columns + 1, d = c + 1;
            part.indices.insert(part.indices.end(), {a, b, d, a, d, c});
        }
    return part;
}

inline model::Model keyed_sheet(uint32_t columns, uint32_t rows, const model::Image &image,
                                const std::vector<uint8_t> &keys)
{
    model::Model m = empty_model();
    for (const uint8_t key : keys) {
        model::Zone zone;
        zone.name = "zone " + std::to_string(key);
        zone.key = key;
        zone.colour = {float(key) / 255, 0.5f, 0.25f};
        m.zones.push_back(zone);
    }
    m.images.push_back(image);
    m.materials.emplace_back();
    m.materials[0].image = 0;
    m.parts.push_back(sheet_part(columns, rows));
    return m;
}

// A checkerboard finer than its triangles: every triangle is dirty, with about as many zones as possible.
inline model::Model torture(uint32_t zone_count, uint8_t first_key, uint32_t key_step)
{
    std::vector<uint8_t> keys;
    for (uint32_t i = 0; i < zone_count; ++i) keys.push_back(uint8_t(first_key + i * key_step));
    const auto key = [&](uint32_t x, uint32_t y) { return keys[(x * 7 + y * 13) % zone_count]; };
    return keyed_sheet(4, 4, key_image(64, 64, key), keys);
}

inline std::unique_ptr<model::Template> built(const model::Model &m, uint32_t max_px = 1024)
{
    auto out = std::make_unique<model::Template>(std::pmr::get_default_resource());
    meshsplit::BuildOptions options;
    options.max_texture_px = max_px;
    meshsplit::build(m, options, *out);
    return out;
}

}  // namespace claque::test
