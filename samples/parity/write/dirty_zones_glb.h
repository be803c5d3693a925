// The zones of dirty primitives in scene.glb, for renderers that draw zone by zone.
#pragma once

#include <map>
#include <optional>
#include <tuple>

#include "samples/parity/write/glb.h"
#include "samples/parity/write/texels.h"

namespace parity
{

class DirtyZones
{
public:
    explicit DirtyZones(Glb &glb) : glb_(glb) {}
    // Adds `zones` and `zone_indices` to the extras of a dirty primitive, in one texture set. Texture sets that agree
    // share their indices. Throws scenes::Failure.
    void describe(Glb::Json &extras, const clq_template *tmpl, const clq_triangles &triangles, const float *uvs,
                  uint32_t texture_set);

private:
    const Texels &texels(const clq_template *tmpl, uint32_t texture, uint32_t texture_set);

    Glb &glb_;
    std::optional<Texels> texels_;  // of the last call
    std::tuple<const clq_template *, uint32_t, uint32_t> texels_of_;
    std::map<std::vector<uint32_t>, size_t> accessors_;
};

}  // namespace parity
