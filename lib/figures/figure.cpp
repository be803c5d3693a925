#include "lib/figures/figure.h"

#include <map>
#include <tuple>

#include "lib/figures/clips.h"
#include "lib/figures/occlusion.h"
#include "lib/figures/painters.h"
#include "lib/figures/parts.h"
#include "lib/figures/weights.h"

namespace claque::figures
{

namespace
{

Mesh model_citizen()
{
    Mesh mesh;
    add_head(mesh);
    add_tunic(mesh);
    for (const Side side : {Side::left, Side::right}) {
        add_arm(mesh, side);
        add_leg(mesh, side);
    }
    unwrap(mesh);
    return mesh;
}

// One vertex for each point and place in the texture; normals are the point's, so that seams do not show.
model::Part part_of(const Mesh &mesh)
{
    const std::vector<glm::vec3> normals = mesh.smooth_normals();
    const std::vector<Binding> bindings = bind(mesh);
    model::Part part;
    part.name = "citizen";
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

model::Model citizen()
{
    const Mesh mesh = model_citizen();
    const Occlusion occlusion(mesh);
    model::Model model;
    model.name = "citizen";
    add_skeleton(model.rig);
    add_clips(model.rig);
    for (int z = 0; z < zone_count; ++z) model.zones.push_back(zone_of(static_cast<Zone>(z)));
    model.images.push_back(paint(
        mesh, [&](glm::vec3 p, glm::vec3 n) { return occlusion.openness(p, n); }, paint_citizen));
    model::Material material;
    material.name = "citizen";
    material.image = 0;
    material.wrap_s = material.wrap_t = model::Wrap::clamp;
    model.materials.push_back(material);
    model.parts.push_back(part_of(mesh));
    model::check(model);
    return model;
}

}  // namespace claque::figures
