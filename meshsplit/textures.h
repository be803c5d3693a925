// Planned textures to the ones that GL is given: powers of two, gutters filled, alpha renumbered. S2 2.3, SPEC 2
// 'Keys'.
#pragma once

#include "lib/model/template.h"
#include "meshsplit/mesh.h"
#include "meshsplit/zone_map.h"

namespace claque::meshsplit
{

// The image as it is planned to look, at its own size, before gutters and changes of size. Throws base::Error
// (ARGUMENT) where a texel has a key that no zone declares. `image` is the plan's own or one of another texture set.
ZoneMap source_map(const model::Model &model, const TexturePlan &plan, uint32_t image);

// Appends one texture for each plan that the mesh's surfaces show; the mesh holds whatever is shown at any distance.
// Returns the number of each plan's texture, or none.
std::vector<uint32_t> make_textures(const model::Model &model, const MaterialPlan &materials, uint32_t max_texture_px,
                                    const Mesh &mesh, model::Array<model::Texture> &out);

}  // namespace claque::meshsplit
