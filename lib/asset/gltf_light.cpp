#include "lib/asset/gltf_light.h"

#include <algorithm>
#include <string_view>

#include "lib/asset/srgb.h"

namespace claque::asset
{

Light read_light(const JsonView &material)
{
    Light out;
    const JsonView extensions = material["extensions"];
    out.unlit = extensions["KHR_materials_unlit"].exists();
    const JsonView factor = material["emissiveFactor"];
    if (out.unlit || !factor.exists()) return out;
    const float strength = extensions["KHR_materials_emissive_strength"]["emissiveStrength"].real_or(1);
    factor.numbers(out.emission.data(), 3);
    for (float &e : out.emission) e = encoded(e * strength);
    out.texture = material["emissiveTexture"];
    return out;
}

void note_unseen_looks(const JsonView &material, std::vector<std::string> &names)
{
    constexpr std::string_view seen[] = {"KHR_materials_unlit", "KHR_materials_emissive_strength",
                                         "KHR_materials_pbrSpecularGlossiness"};
    const JsonView extensions = material["extensions"];
    if (!extensions.exists()) return;
    for (const auto &member : extensions.object().items()) {
        const std::string &name = member.key();
        if (name.find("_materials_") == std::string::npos || name.size() > 100) continue;
        if (std::find(std::begin(seen), std::end(seen), name) != std::end(seen)) continue;
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
}

bool has_one_colour(const model::Image &image, std::array<float, 3> &out)
{
    constexpr int most_apart = 3;  // of 255: what JPEG does to one colour
    uint64_t sums[3] = {0, 0, 0};
    int low[3] = {255, 255, 255}, high[3] = {0, 0, 0};
    for (size_t i = 0; i < image.rgba.size(); i += 4)
        for (size_t k = 0; k < 3; ++k) {
            const int value = image.rgba[i + k];
            low[k] = std::min(low[k], value), high[k] = std::max(high[k], value);
            sums[k] += static_cast<uint64_t>(value);
        }
    const size_t texels = image.rgba.size() / 4;
    for (size_t k = 0; k < 3; ++k) {
        if (high[k] - low[k] > most_apart) return false;
        out[k] = static_cast<float>(static_cast<double>(sums[k]) / static_cast<double>(texels) / 255);
    }
    return true;
}

AlphaExtent alpha_extent_of(const model::Image &image)
{
    uint8_t least = 255, most = 0;
    for (size_t i = 3; i < image.rgba.size(); i += 4)
        least = std::min(least, image.rgba[i]), most = std::max(most, image.rgba[i]);
    return {static_cast<float>(least) / 255, static_cast<float>(most) / 255};
}

}  // namespace claque::asset
