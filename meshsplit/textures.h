// Makes the GL textures of planned textures: powers of two, filled gutters, renumbered alpha. S2 2.3.
#pragma once

#include "lib/model/template.h"
#include "meshsplit/mesh.h"
#include "meshsplit/zone_map.h"

namespace claque::meshsplit
{

// Returns the planned texture at its own size, before gutters and resizing. Throws base::Error (ARGUMENT) if a texel
// has a key that no zone declares. `image` is the plan's own or one of another texture set.
ZoneMap source_map(const model::Model &model, const TexturePlan &plan, uint32_t image);

// Appends one texture for each plan that the mesh's surfaces use; the mesh contains everything visible at any distance.
// Returns the texture index of each plan, or none.
std::vector<uint32_t> make_textures(const model::Model &model, const MaterialPlan &materials, uint32_t max_texture_px,
                                    const Mesh &mesh, model::Array<model::Texture> &out);

}  // namespace claque::meshsplit
