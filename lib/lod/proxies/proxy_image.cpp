#include "lib/lod/proxies/proxy_image.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace claque::lod
{

model::Image empty_image(uint32_t width, uint32_t height)
{
    model::Image image;
    image.width = width, image.height = height;
    image.alpha = model::AlphaMeaning::zone_keys;
    image.rgba.assign(4 * size_t(width) * height, 255);
    return image;
}

void set_texel(const ProxySource &source, size_t at, uint32_t zone, glm::dvec3 rgb, model::Image &image)
{
    uint8_t *texel = image.rgba.data() + 4 * at;
    for (int k = 0; k < 3; ++k) texel[k] = static_cast<uint8_t>(std::lround(255 * std::clamp(rgb[k], 0.0, 1.0)));
    texel[3] = zone == model::none ? 255 : source.keys[zone];
}

void split_by_uv(model::Part &part, const std::vector<glm::vec2> &corners)
{
    const model::Part from = part;
    part.positions.clear(), part.normals.clear(), part.uvs.clear(), part.joints.clear(), part.weights.clear();
    std::map<std::tuple<uint32_t, float, float>, uint32_t> known;
    for (size_t i = 0; i < part.indices.size(); ++i) {
        const uint32_t v = part.indices[i];
        const auto [at, fresh] =
            known.try_emplace({v, corners[i].x, corners[i].y}, static_cast<uint32_t>(part.positions.size()));
        part.indices[i] = at->second;
        if (!fresh) continue;
        part.positions.push_back(from.positions[v]);
        part.normals.push_back(from.normals[v]);
        part.uvs.push_back(corners[i]);
        const size_t n = part.influence_count;
        for (size_t k = n * v; k < n * v + n; ++k)
            part.joints.push_back(from.joints[k]), part.weights.push_back(from.weights[k]);
    }
}

}  // namespace claque::lod
