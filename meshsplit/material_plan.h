// Plans the textures of materials: zone or zone keys, RGB, and UV mapping. Each material has one mapping. Materials
// that show the same share a texture, and all materials without an image share a small palette.
//
// An individual without colours of its own must look like the file: texture x base colour x zone colour. A zone whose
// colour equals the base colour of one of its materials holds base colours: its colour becomes the maximum of them, per
// channel, and each material's RGB contains the remaining factor, at most 1. Any other zone has a colour set by its
// author, and the RGB contains the whole base colour.
#pragma once

#include <glm/vec2.hpp>

#include "meshsplit/near_colours.h"

namespace claque::meshsplit
{

// One cell of a palette texture.
struct Cell {
    uint32_t zone = 0;
    Rgb rgb = {1, 1, 1};
    bool is_hole = false;
};

struct TexturePlan {
    uint32_t image = model::none;  // none: a palette of `cells`
    std::vector<uint32_t> others;  // images, one for each of the model's texture sets; none: same as `image`
    model::Wrap wrap_s = model::Wrap::repeat, wrap_t = model::Wrap::repeat;  // mirror: will be unfolded
    uint32_t zone = model::none;  // none: the image's alpha contains zone keys
    Rgb rgb = {1, 1, 1};          // multiplies the image
    bool masked = false;
    float cutoff = 0;  // for the image's alpha, in [0, 1]; texels below it are holes
    std::vector<Cell> cells;

    // Equal for planned textures of images that differ in nothing but `rgb`.
    std::string family() const;
};

struct MaterialMapping {
    uint32_t texture = 0;
    bool double_sided = false;
    model::Lighting lighting;
    // Converts the file's UVs to those of the GL texture: offset + scale * uv.
    glm::vec2 uv_scale = glm::vec2(1);
    glm::vec2 uv_offset = glm::vec2(0);
};

struct MaterialPlan {
    std::vector<model::Zone> zones;  // the model's zones, then new ones for materials without a zone
    std::vector<TexturePlan> textures;
    std::vector<MaterialMapping> mappings;  // one per material, then one for parts without a material

    const MaterialMapping &of(const model::Part &part) const
    {
        return mappings[part.material == model::none ? mappings.size() - 1 : part.material];
    }
};

// Cells are square; a triangle in one has all its corners at the centre.
constexpr uint32_t cell_px = 4;
uint32_t palette_side(uint32_t cell_count);  // cells along one side of a square palette, a power of two

// Palettes contain at most this many zones, so that every strategy can tell them apart.
constexpr uint32_t max_palette_zones = 48;

// Mappings of materials that no visible triangle uses stay empty.
MaterialPlan plan_materials(const model::Model &model);

}  // namespace claque::meshsplit
