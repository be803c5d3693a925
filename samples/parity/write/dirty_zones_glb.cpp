#include "samples/parity/write/dirty_zones_glb.h"

#include "samples/parity/write/zone_cover.h"

namespace parity
{

const Texels &DirtyZones::texels(const clq_template *tmpl, uint32_t texture, uint32_t texture_set)
{
    const auto wanted = std::make_tuple(tmpl, texture, texture_set);
    if (!texels_ || texels_of_ != wanted) texels_.emplace(tmpl, texture, texture_set);
    texels_of_ = wanted;
    return *texels_;
}

void DirtyZones::describe(Glb::Json &extras, const clq_template *tmpl, const clq_triangles &triangles, const float *uvs,
                          uint32_t texture_set)
{
    constexpr int indices = 34963;
    extras["zones"] = extras["zone_indices"] = Glb::Json::array();
    for (const ZoneTriangles &found : zone_cover(triangles, uvs, texels(tmpl, triangles.texture, texture_set))) {
        const auto [known, is_new] = accessors_.try_emplace(found.indices, 0);
        if (is_new)
            known->second =
                glb_.accessor(found.indices.data(), found.indices.size(), "SCALAR", Glb::unsigned_int, indices);
        extras["zones"].push_back(found.zone);
        extras["zone_indices"].push_back(known->second);
    }
}

}  // namespace parity
