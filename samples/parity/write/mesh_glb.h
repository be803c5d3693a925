// One mesh of a template as glTF has it.
#pragma once

#include "samples/parity/write/drawn_actors.h"
#include "samples/parity/write/glb.h"

#include <map>
#include <tuple>

namespace parity
{

// Materials of one file: one for each texture, texture set and sidedness of each template.
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
    std::map<std::pair<size_t, int32_t>, size_t> materials_;  // by texture and sidedness
};

// The glTF mesh without materials, and these, which are all that texture sets differ in. Throw scenes::Failure.
Glb::Json mesh_json(Glb &glb, const clq_template *tmpl, uint32_t level);
void dress(Glb::Json &mesh, Materials &materials, const clq_template *tmpl, const MeshName &name);

}  // namespace parity
