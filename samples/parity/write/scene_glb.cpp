#include "samples/parity/write/scene_glb.h"

#include <cmath>
#include <map>

#include "samples/parity/write/mesh_glb.h"
#include "samples/scenes/check.h"

namespace parity
{

using Json = Glb::Json;

namespace
{

// Column by column, with the row that an affine matrix lacks.
Json matrix_of_rows(const float *rows)
{
    Json out = Json::array();
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) out.push_back(rows[4 * row + column]);
        out.push_back(column == 3 ? 1 : 0);
    }
    return out;
}

// Joints below a node at the individual's position in eye space; the mesh is beside them, placed by its skin.
void stand(Json &json, const Individual &person, const float *palette, size_t mesh, const std::string &name)
{
    Json joints = Json::array();
    for (uint32_t joint = 0; joint < person.drawn_actors.joint_count; ++joint) {
        json["nodes"].push_back({{"matrix", matrix_of_rows(palette + 12 * static_cast<size_t>(joint))}});
        joints.push_back(json["nodes"].size() - 1);
    }
    json["skins"].push_back({{"joints", joints}});
    json["nodes"].push_back({{"name", name}, {"matrix", person.drawn_actors.model_view}, {"children", joints}});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
    json["nodes"].push_back({{"name", name + ", mesh"}, {"mesh", mesh}, {"skin", json["skins"].size() - 1}});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
}

// glTF has no off-axis cameras.
void add_camera(Json &json, const float *p)
{
    const bool perspective = p[11] == -1 && p[15] == 0 && p[8] == 0 && p[9] == 0 && p[0] > 0 && p[5] > 0;
    if (!perspective) return;
    const double a = static_cast<double>(p[10]), b = static_cast<double>(p[14]), y = static_cast<double>(p[5]);
    json["cameras"] = Json::array({{{"type", "perspective"},
                                    {"perspective",
                                     {{"aspectRatio", y / static_cast<double>(p[0])},
                                      {"yfov", 2 * std::atan(1 / y)},
                                      {"znear", b / (a - 1)},
                                      {"zfar", b / (a + 1)}}}}});
    json["nodes"].push_back({{"name", "camera"}, {"camera", 0}});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
}

}  // namespace

std::string scene_glb(const DrawnActors &drawn_actors, const std::vector<float> &palettes, const float projection[16])
{
    Glb glb;
    Json &json = glb.json;
    json["asset"] = {{"version", "2.0"}, {"generator", "claque parity export"}};
    json["scene"] = 0;
    json["scenes"] = Json::array({{{"nodes", Json::array()}}});
    Materials materials(glb);
    DirtyZones dirty_zones(glb);
    std::map<std::pair<uint32_t, uint32_t>, Json> shapes;  // by template and level
    for (const MeshName &name : drawn_actors.meshes()) {
        const clq_template *tmpl = drawn_actors.templates()[name.tmpl];
        const auto [known, is_new] = shapes.try_emplace({name.tmpl, name.level});
        if (is_new) known->second = mesh_json(glb, tmpl, name.level);
        Json mesh = known->second;
        dress(mesh, materials, dirty_zones, tmpl, name);  // adds members to the document, which moves its contents
        clq_template_info info = clq_template_info_init();
        scenes::check(clq_template_get_info(tmpl, &info));
        mesh["name"] = std::string(info.name) + ", level " + std::to_string(name.level);
        json["meshes"].push_back(mesh);
    }
    std::vector<bool> stands(drawn_actors.meshes().size(), false);
    for (const Individual &person : drawn_actors.individuals()) {
        if (stands[person.mesh]) continue;
        stands[person.mesh] = true;
        stand(json, person, palettes.data() + 12 * static_cast<size_t>(person.first_palette), person.mesh,
              json["meshes"][person.mesh]["name"]);
    }
    add_camera(json, projection);
    return glb.file();
}

}  // namespace parity
