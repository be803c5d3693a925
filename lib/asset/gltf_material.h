// Reads what GL 1.1 can show of materials: base colour, one texture, alpha test, sidedness, emission.
#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_map>

#include "lib/asset/gltf_file.h"
#include "lib/asset/gltf_light.h"
#include "lib/asset/gltf_variants.h"

namespace claque::asset
{

// KHR_texture_transform: scale, then rotation about the origin, then translation.
struct UvTransform {
    float m[6] = {1, 0, 0, 1, 0, 0};  // by column: x axis, y axis, translation
    glm::vec2 applied(glm::vec2 uv) const
    {
        return glm::vec2(m[0] * uv.x + m[2] * uv.y + m[4], m[1] * uv.x + m[3] * uv.y + m[5]);
    }
};

// The texture coordinates that a material needs.
struct UvUse {
    bool has_texture = false;
    uint32_t set = 0;
    UvTransform transform;
};

// The file's materials, checked, and additional ones: one for primitives without a material, and untextured copies for
// primitives without texture coordinates. Only images of used materials are decoded.
class Materials
{
public:
    explicit Materials(File &file);

    // The material of a primitive; it is not marked as used.
    uint32_t reference(const JsonView &view);
    uint32_t without_texture(uint32_t material);
    const UvUse &uv_use(uint32_t material) const { return uv_uses_[material]; }
    size_t count() const { return materials_.size(); }
    // Records the materials that variants give to a primitive with this material.
    void note_variants(uint32_t material, const JsonView &primitive)
    {
        variants_.note(material, primitive, views_.size());
    }

    // Decodes the images of materials in `used`, gives each of these materials a zone (or its image's alpha the meaning
    // of zone keys), and moves everything into the model. To be called once, at the end.
    void finish(const std::vector<bool> &used, model::Model &model);

private:
    void read(const JsonView &view);
    void read_texture(const JsonView &info, model::Material &out, UvUse &use);
    void read_alpha(const JsonView &view, model::Material &out);
    bool has_picture(const JsonView &info) const;
    void read_emission(const Light &light, model::Material &out, UvUse &use);
    void add_emission_of_pictures(const std::vector<bool> &used, const model::Model &model);
    std::string settle_alpha(uint32_t material, const model::Model &model);
    void name_unseen_looks(const std::vector<bool> &used);
    void settle_light(const std::vector<bool> &used, model::Model &model);
    void keep_glow(const std::vector<bool> &used, model::Model &model) const;
    uint32_t image_source(const JsonView &texture);
    void decode_images(const std::vector<bool> &used, model::Model &model);
    uint32_t decoded(uint32_t source, model::Model &model);  // none if its file is missing
    void add_texture_sets(const std::vector<bool> &used, model::Model &model);
    uint32_t image_of_variant(uint32_t material, uint32_t other, const std::string &variant, model::Model &model);
    void add_keys(model::Image &image, const JsonView &extras, model::Model &model);
    void mark_keyed(const std::vector<bool> &used, model::Model &model);

    File &file_;
    std::vector<model::Material> materials_;  // `image` is an index of the file's images until finish()
    std::vector<UvUse> uv_uses_;
    std::vector<JsonView> views_;
    std::map<uint32_t, uint32_t> untextured_;  // copies without a texture
    std::set<uint32_t> blended_;               // of alpha mode BLEND
    std::set<uint32_t> glowing_;               // whose base colour is their emission
    struct EmissionPicture {
        std::array<float, 3> factor;
        uint32_t image;  // of the file
    };
    std::map<uint32_t, EmissionPicture> emission_pictures_;  // that differ from the base colour's, by material
    uint32_t default_ = none;
    Variants variants_;
    std::vector<uint32_t> sources_;                     // by image of the model: the image of the file
    std::vector<uint32_t> file_images_;                 // by material: the image of the file, used or not
    std::map<uint32_t, uint32_t> decoded_;              // by image of the file: that of the model
    std::unordered_map<std::string, uint32_t> images_;  // by where the bytes are: the image of the model
};

}  // namespace claque::asset
