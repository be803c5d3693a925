#include "lib/figures/assemble.h"

#include <map>
#include <tuple>

#include "lib/figures/ambient_occlusion.h"

namespace claque::figures
{

namespace
{

// One vertex for each pair of point and texture position. Normals are those of the point, so that seams do not show.
model::Part part_of(const Mesh &mesh, Weigher weigher)
{
    const std::vector<glm::vec3> normals = mesh.smooth_normals();
    const std::vector<Binding> bindings = bind(mesh, weigher);
    model::Part part;
    part.skinned = true;
    part.node = 0;
    part.material = 0;
    part.influence_count = 4;
    std::map<std::tuple<uint32_t, float, float>, uint32_t> made;
    for (const Face &face : mesh.faces)
        for (const Corner &corner : face.corners) {
            const auto [at, fresh] = made.try_emplace({corner.point, corner.uv.x, corner.uv.y},
                                                      static_cast<uint32_t>(part.positions.size()));
            part.indices.push_back(at->second);
            if (!fresh) continue;
            part.positions.push_back(mesh.points[corner.point].position);
            part.normals.push_back(normals[corner.point]);
            part.uvs.push_back(corner.uv);
            const Binding &binding = bindings[corner.point];
            part.joints.insert(part.joints.end(), binding.bones.begin(), binding.bones.end());
            part.weights.insert(part.weights.end(), binding.weights.begin(), binding.weights.end());
        }
    return part;
}

}  // namespace

model::Model assemble(const Figure &figure)
{
    Mesh mesh;
    figure.add_pieces(mesh);
    unwrap(mesh, figure.layout);
    const AmbientOcclusion occlusion(mesh);
    model::Model model;
    model.name = figure.name;
    add_skeleton(model.rig);
    for (const ClipMaker &clip : figure.clips) add_clip(model.rig, clip, figure.fit);
    model.first_late_clip = first_late_clip;
    model.late_clip_count = static_cast<uint32_t>(figure.clips.size()) - first_late_clip;
    model.zones = zones_of(figure.zones);
    std::vector<Painter> painters = {figure.painter};
    for (const Figure::TextureSet &look : figure.texture_sets) painters.push_back(look.painter);
    model.images = paint(
        mesh, [&](glm::vec3 p, glm::vec3 n) { return occlusion.ambient_visibility(p, n); }, painters, figure.zones);
    model.images[0].name = figure.name;
    for (uint32_t i = 0; i < figure.texture_sets.size(); ++i) {
        model.images[i + 1].name = std::string(figure.name) + " " + figure.texture_sets[i].name;
        model.texture_sets.push_back({figure.texture_sets[i].name, {i + 1}});
    }
    model::Material material;
    material.name = figure.name;
    material.image = 0;
    material.wrap_s = material.wrap_t = model::Wrap::clamp;
    model.materials.push_back(material);
    model.parts.push_back(part_of(mesh, figure.weigher));
    model.parts[0].name = figure.name;
    model::check(model);
    return model;
}

}  // namespace claque::figures
