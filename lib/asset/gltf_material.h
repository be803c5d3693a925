// Materials as far as GL 1.1 shows them: a base colour, one texture, cut-out alpha, sidedness.
#pragma once

#include <map>

#include "lib/asset/gltf_file.h"
#include "lib/asset/gltf_variants.h"

namespace claque::asset
{

// KHR_texture_transform: scale, then rotation about the origin, then offset.
struct UvTransform {
    float m[6] = {1, 0, 0, 1, 0, 0};  // by column: x axis, y axis, offset
    glm::vec2 applied(glm::vec2 uv) const
    {
        return glm::vec2(m[0] * uv.x + m[2] * uv.y + m[4], m[1] * uv.x + m[3] * uv.y + m[5]);
    }
};

// Which texture coordinates a material wants.
struct UvUse {
    bool has_texture = false;
    uint32_t set = 0;
    UvTransform transform;
};

// The file's materials, checked, and those that parts turn out to need besides: one for primitives without any, and
// copies without a texture for primitives without coordinates. Images are decoded for materials in use only.
class Materials
{
public:
    explicit Materials(File &file);

    // The material of a primitive; marks nothing as used.
    uint32_t reference(const JsonView &view);
    uint32_t without_texture(uint32_t material);
    const UvUse &uv_use(uint32_t material) const { return uv_uses_[material]; }
    size_t count() const { return materials_.size(); }
    // What variants show of a primitive with this material.
    void note_variants(uint32_t material, const JsonView &primitive)
    {
        variants_.note(material, primitive, views_.size());
    }

    // Decodes what `used` (by material) need, gives every used material a zone (or its image's alpha the meaning of
    // zone keys), and hands everything over. Once, at the end.
    void finish(const std::vector<bool> &used, model::Model &model);

private:
    void read(const JsonView &view);
    void read_texture(const JsonView &info, model::Material &out, UvUse &use);
    void read_alpha(const JsonView &view, model::Material &out);
    uint32_t image_source(const JsonView &texture);
    void decode_images(const std::vector<bool> &used, model::Model &model);
    uint32_t decoded(uint32_t source, model::Model &model);
    void add_texture_sets(const std::vector<bool> &used, model::Model &model);
    uint32_t image_of_variant(uint32_t material, uint32_t other, const std::string &variant, model::Model &model);
    void add_keys(model::Image &image, const JsonView &extras, model::Model &model);
    void mark_keyed(const std::vector<bool> &used, model::Model &model);

    File &file_;
    std::vector<model::Material> materials_;  // image: an index of the file's images until finish()
    std::vector<UvUse> uv_uses_;
    std::vector<JsonView> views_;
    std::map<uint32_t, uint32_t> untextured_;  // copies without texture
    uint32_t default_ = none;
    Variants variants_;
    std::vector<uint32_t> sources_;         // by image of the model: the image of the file
    std::vector<uint32_t> file_images_;     // by material: the image of the file, whether or not it is used
    std::map<uint32_t, uint32_t> decoded_;  // by image of the file: that of the model
};

}  // namespace claque::asset
