#include "samples/parity/write/mesh_glb.h"

#include <algorithm>

#include "samples/scenes/check.h"

namespace parity
{

using scenes::check;
using Json = Glb::Json;

namespace
{

constexpr int vertices = 34962, indices = 34963;

// glTF requires the bounding box of positions.
void add_box(Json &accessor, const clq_mesh &mesh)
{
    Json low = Json::array(), high = Json::array();
    for (uint32_t axis = 0; axis < 3; ++axis) {
        float least = mesh.vertex_count ? mesh.positions[axis] : 0, most = least;
        for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
            least = std::min(least, mesh.positions[3 * v + axis]);
            most = std::max(most, mesh.positions[3 * v + axis]);
        }
        low.push_back(least), high.push_back(most);
    }
    accessor["min"] = low, accessor["max"] = high;
}

// In sets of four.
void add_influences(Glb &glb, Json &attributes, const clq_template *tmpl, uint32_t level, const clq_mesh &mesh)
{
    const uint32_t sets = (std::max(mesh.influence_count, 1u) + 3) / 4, each = 4 * sets;
    std::vector<uint16_t> joints(static_cast<size_t>(each) * mesh.vertex_count);
    std::vector<float> weights(joints.size());
    clq_influences influences = clq_influences_init();
    influences.per_vertex = each, influences.capacity = joints.size();
    influences.joints = joints.data(), influences.weights = weights.data();
    check(clq_template_get_influences(tmpl, level, &influences));
    for (uint32_t set = 0; set < sets; ++set) {
        std::vector<uint16_t> j;
        std::vector<float> w;
        for (size_t v = 0; v < mesh.vertex_count; ++v)
            for (size_t k = 0; k < 4; ++k) {
                j.push_back(joints[v * each + 4 * set + k]);
                w.push_back(weights[v * each + 4 * set + k]);
            }
        const std::string n = std::to_string(set);
        attributes["JOINTS_" + n] = glb.accessor(j.data(), mesh.vertex_count, "VEC4", Glb::unsigned_short, vertices);
        attributes["WEIGHTS_" + n] = glb.accessor(w.data(), mesh.vertex_count, "VEC4", Glb::real, vertices);
    }
}

Json attributes_of(Glb &glb, const clq_template *tmpl, uint32_t level, const clq_mesh &mesh)
{
    Json position = {{"bufferView", glb.view(mesh.positions, 12 * static_cast<size_t>(mesh.vertex_count), vertices)},
                     {"componentType", Glb::real},
                     {"count", mesh.vertex_count},
                     {"type", "VEC3"}};
    add_box(position, mesh);
    Json out;
    out["POSITION"] = glb.add(position);
    out["NORMAL"] = glb.accessor(mesh.normals, mesh.vertex_count, "VEC3", Glb::real, vertices);
    out["TEXCOORD_0"] = glb.accessor(mesh.uvs, mesh.vertex_count, "VEC2", Glb::real, vertices);
    if (mesh.colours)
        out["COLOR_0"] = glb.accessor(mesh.colours, mesh.vertex_count, "VEC4", Glb::unsigned_byte, vertices, true);
    add_influences(glb, out, tmpl, level, mesh);
    return out;
}

// glTF requires ascending sparse indices.
Json target_of(Glb &glb, const clq_morph_target &target, uint32_t vertex_count)
{
    std::vector<const clq_morph_delta *> deltas;
    for (uint32_t i = 0; i < target.delta_count; ++i) deltas.push_back(target.deltas + i);
    std::sort(deltas.begin(), deltas.end(),
              [](const clq_morph_delta *a, const clq_morph_delta *b) { return a->vertex < b->vertex; });
    std::vector<uint32_t> vertices;
    std::vector<float> xyz[2];
    for (const clq_morph_delta *delta : deltas) {
        vertices.push_back(delta->vertex);
        xyz[0].insert(xyz[0].end(), delta->position, delta->position + 3);
        xyz[1].insert(xyz[1].end(), delta->normal, delta->normal + 3);
    }
    Json out;
    for (int k = 0; k < 2; ++k) {
        Json accessor = {{"componentType", Glb::real}, {"count", vertex_count}, {"type", "VEC3"}};
        if (!vertices.empty())
            accessor["sparse"] = {{"count", vertices.size()},
                                  {"indices",
                                   {{"bufferView", glb.view(vertices.data(), 4 * vertices.size())},
                                    {"componentType", Glb::unsigned_int}}},
                                  {"values", {{"bufferView", glb.view(xyz[k].data(), 4 * xyz[k].size())}}}};
        out[k == 0 ? "POSITION" : "NORMAL"] = glb.add(accessor);
    }
    return out;
}

}  // namespace

Json mesh_json(Glb &glb, const clq_template *tmpl, uint32_t level)
{
    clq_mesh mesh = clq_mesh_init();
    check(clq_template_get_mesh(tmpl, level, &mesh));
    const Json attributes = attributes_of(glb, tmpl, level, mesh);
    Json targets = Json::array(), weights = Json::array(), zeros = Json::array();
    for (uint32_t i = 0; i < mesh.morph_count; ++i) {
        clq_morph_target target = clq_morph_target_init();
        check(clq_template_get_morph_target(tmpl, level, i, &target));
        targets.push_back(target_of(glb, target, mesh.vertex_count));
        weights.push_back(target.weight);
        zeros.push_back(0);
    }
    Json out = {{"primitives", Json::array()}};
    for (uint32_t bin = 0; bin < mesh.bin_count; ++bin) {
        clq_triangles triangles = clq_triangles_init();
        check(clq_template_get_triangles(tmpl, level, bin, &triangles));
        Json primitive = {
            {"attributes", attributes},
            {"indices", glb.accessor(triangles.indices, triangles.index_count, "SCALAR", Glb::unsigned_int, indices)},
            {"extras", {{"zone", triangles.zone == CLQ_NONE ? Json(nullptr) : Json(triangles.zone)}}}};
        if (!targets.empty()) primitive["targets"] = targets;
        out["primitives"].push_back(primitive);
    }
    if (!targets.empty()) out["weights"] = zeros, out["extras"] = {{"morph_weights", weights}};
    return out;
}

void dress(Json &mesh, Materials &materials, DirtyZones &dirty_zones, const clq_template *tmpl, const MeshName &name)
{
    clq_mesh arrays = clq_mesh_init();
    check(clq_template_get_mesh(tmpl, name.level, &arrays));
    for (uint32_t bin = 0; bin < mesh["primitives"].size(); ++bin) {
        clq_triangles triangles = clq_triangles_init();
        check(clq_template_get_triangles(tmpl, name.level, bin, &triangles));
        Json &primitive = mesh["primitives"][bin];
        primitive["material"] = materials.material(tmpl, triangles, name.texture_set);
        if (triangles.zone == CLQ_NONE)
            dirty_zones.describe(primitive["extras"], tmpl, triangles, arrays.uvs, name.texture_set);
    }
}

}  // namespace parity
