// The individuals drawn in a view and their meshes: the tables that both kinds of parity folders share.
#pragma once

#include <claque/claque.h>
#include <claque/drawn_actor.h>
#include <claque/mesh.h>

#include <vector>

#include <nlohmann/json.hpp>

#include "samples/parity/write/files.h"

namespace parity
{

using Json = nlohmann::ordered_json;

// One level of detail of one template in one of its texture sets.
struct MeshName {
    uint32_t tmpl = 0;  // of DrawnActors::templates
    uint32_t level = 0, texture_set = 0;
};

struct Individual {
    clq_drawn_actor drawn_actors = clq_drawn_actor_init();
    uint32_t place = 0;       // in the view's list
    uint32_t draw_order = 0;  // among the drawn individuals
    uint32_t mesh = 0;
    uint32_t first_vertex = 0, first_palette = 0, first_weight = 0;
};

class DrawnActors
{
public:
    // From the view's last update. Throws scenes::Failure.
    explicit DrawnActors(const clq_view *view);

    const clq_view *view() const { return view_; }
    // In the order in which individuals show them.
    const std::vector<const clq_template *> &templates() const { return templates_; }
    // Every level of each template in every texture set.
    const std::vector<MeshName> &meshes() const { return meshes_; }
    // Ascending by actor; without individuals of which only the shadow is visible.
    const std::vector<Individual> &individuals() const { return individuals_; }
    size_t vertices() const { return vertices_; }
    size_t palette_rows() const { return palette_rows_; }
    size_t morph_weights() const { return morph_weights_; }

    // actors.npy, and capture.json's entries for individuals, templates and meshes.
    void write_actors(Folder &folder) const;
    void describe(Json &out) const;

private:
    uint32_t mesh_of(const clq_drawn_actor &drawn_actors);

    const clq_view *view_;
    std::vector<const clq_template *> templates_;
    std::vector<uint32_t> first_mesh_;  // of each template
    std::vector<MeshName> meshes_;
    std::vector<Individual> individuals_;
    size_t vertices_ = 0, palette_rows_ = 0, morph_weights_ = 0;
};

// Skinned positions and normals of all individuals, and the size of each: the longest side of its bounding box.
struct Skinned {
    explicit Skinned(const DrawnActors &drawn_actors);
    std::vector<float> positions, normals, sizes;
};

}  // namespace parity
