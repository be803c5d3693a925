// One mesh of a template as glTF.
#pragma once

#include <array>
#include <map>
#include <tuple>

#include "samples/parity/write/dirty_zones_glb.h"
#include "samples/parity/write/drawn_actors.h"

namespace parity
{

// Materials of one file: one for each texture, texture set, sidedness and lighting of each template.
class Materials
{
public:
    explicit Materials(Glb &glb) : glb_(glb) {}
    size_t material(const clq_template *tmpl, const clq_triangles &triangles, uint32_t texture_set);

private:
    struct Image {
        size_t texture;
        bool holes;
    };
    Image image(const clq_template *tmpl, uint32_t texture, uint32_t texture_set);

    Glb &glb_;
    std::map<std::tuple<const clq_template *, uint32_t, uint32_t>, Image> images_;
    // By texture, sidedness, and lighting: unlit, emission.
    std::map<std::tuple<size_t, bool, bool, std::array<float, 3>>, size_t> materials_;
};

// mesh_json: the glTF mesh without materials; dress: adds the materials and the zones of dirty primitives, in which
// alone texture sets differ. Both throw scenes::Failure.
Glb::Json mesh_json(Glb &glb, const clq_template *tmpl, uint32_t level);
void dress(Glb::Json &mesh, Materials &materials, DirtyZones &dirty_zones, const clq_template *tmpl,
           const MeshName &name);

}  // namespace parity
