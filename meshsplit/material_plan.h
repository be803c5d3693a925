// Materials to textures: which zone or zone keys, which RGB, where in it. One Look a material; materials that show the
// same share a texture, and all that have no image share a small palette.
//
// The picture of an individual that was given no colours must look like the file: texture x base colour x zone colour.
// A zone whose colour equals the base colour of a material of its own is one that holds base colours: its colour
// becomes the largest of them, channel by channel, and each material's RGB carries the rest, at most 1. Any other zone
// has a colour of its author's, and the RGB carries the whole base colour.
#pragma once

#include "lib/model/model.h"

#include <glm/vec2.hpp>

namespace claque::meshsplit
{

using Rgb = std::array<float, 3>;

// One field of a palette texture.
struct Cell {
    uint32_t zone = 0;
    Rgb rgb = {1, 1, 1};
    bool is_hole = false;
};

struct TexturePlan {
    uint32_t image = model::none;  // none: a palette of `cells`
    std::vector<uint32_t> others;  // images, one for each of the model's texture sets; none: as `image`
    model::Wrap wrap_s = model::Wrap::repeat, wrap_t = model::Wrap::repeat;  // mirror: to be unfolded
    uint32_t zone = model::none;                                             // none: the image's alpha holds keys
    Rgb rgb = {1, 1, 1};                                                     // times the image
    bool masked = false;
    float cutoff = 0;  // of the image's alpha, in [0, 1]; below it is a hole
    std::vector<Cell> cells;

    bool same_texture(const TexturePlan &other) const;
};

struct MaterialMapping {
    uint32_t texture = 0;
    bool double_sided = false;
    // UVs that the texture given to GL wants: offset + scale * the file's.
    glm::vec2 uv_scale = glm::vec2(1);
    glm::vec2 uv_offset = glm::vec2(0);
};

struct MaterialPlan {
    std::vector<model::Zone> zones;  // the model's, then those made for materials that have none
    std::vector<TexturePlan> textures;
    std::vector<MaterialMapping> mappings;  // one a material, then one for parts without a material

    const MaterialMapping &of(const model::Part &part) const
    {
        return mappings[part.material == model::none ? mappings.size() - 1 : part.material];
    }
};

// Cells are square and a triangle in one has all corners at its middle.
constexpr uint32_t cell_px = 4;
uint32_t palette_side(uint32_t cell_count);  // cells along one side of a square palette, a power of two

// Palettes take no more zones than this, so that every strategy can tell them apart.
constexpr uint32_t max_palette_zones = 48;

// Looks of materials that no visible triangle uses are left empty.
MaterialPlan plan_materials(const model::Model &model);

}  // namespace claque::meshsplit
