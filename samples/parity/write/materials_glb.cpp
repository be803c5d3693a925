// The materials of scene.glb: a picture of lightness and keys for each texture of a template.
#include <algorithm>

#include "samples/parity/write/mesh_glb.h"
#include "samples/parity/write/texels.h"
#include "samples/scenes/check.h"

namespace parity
{
namespace
{

constexpr int nearest_filter = 9728, repeat = 10497, clamp_to_edge = 33071;  // OpenGL's constants, which glTF uses too
constexpr double least_key = 0.5 / 255;

}  // namespace

Materials::Image Materials::image(const clq_template *tmpl, uint32_t texture, uint32_t texture_set)
{
    const auto key = std::make_tuple(tmpl, texture, texture_set);
    const auto known = images_.find(key);
    if (known != images_.end()) return known->second;
    const Texels texels(tmpl, texture, texture_set);
    const std::vector<uint8_t> png = png_of(texels);
    const auto wrap = [](clq_wrap w) { return w == CLQ_WRAP_CLAMP ? clamp_to_edge : repeat; };
    Glb::Json &json = glb_.json;
    json["images"].push_back({{"mimeType", "image/png"}, {"bufferView", glb_.view(png.data(), png.size())}});
    json["samplers"].push_back({{"magFilter", nearest_filter},
                                {"minFilter", nearest_filter},
                                {"wrapS", wrap(texels.wrap_s)},
                                {"wrapT", wrap(texels.wrap_t)}});
    json["textures"].push_back({{"sampler", json["samplers"].size() - 1}, {"source", json["images"].size() - 1}});
    const bool holes = std::find(texels.zones.begin(), texels.zones.end(), CLQ_NONE) != texels.zones.end();
    return images_[key] = {json["textures"].size() - 1, holes};
}

size_t Materials::material(const clq_template *tmpl, const clq_triangles &triangles, uint32_t texture_set)
{
    const Image drawn_actors = image(tmpl, triangles.texture, texture_set);
    const std::array<float, 3> emission = {triangles.emission[0], triangles.emission[1], triangles.emission[2]};
    const auto [known, is_new] =
        materials_.try_emplace({drawn_actors.texture, triangles.double_sided, triangles.unlit, emission}, 0);
    if (!is_new) return known->second;
    Glb::Json made = {
        {"pbrMetallicRoughness",
         {{"baseColorTexture", {{"index", drawn_actors.texture}}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
        {"doubleSided", triangles.double_sided != 0}};
    if (drawn_actors.holes) made["alphaMode"] = "MASK", made["alphaCutoff"] = least_key;
    if (triangles.unlit) made["extensions"]["KHR_materials_unlit"] = Glb::Json::object();
    if (triangles.unlit) glb_.json["extensionsUsed"] = {"KHR_materials_unlit"};
    if (emission[0] > 0 || emission[1] > 0 || emission[2] > 0)
        made["emissiveFactor"] = emission, made["emissiveTexture"]["index"] = drawn_actors.texture;
    glb_.json["materials"].push_back(made);
    return known->second = glb_.json["materials"].size() - 1;
}

}  // namespace parity
