#include "tests/gl/support/split.h"

#include <stdexcept>

#include "lib/pose/pose.h"
#include "lib/skin/skin.h"
#include "meshsplit/build.h"

namespace gltest
{

void skin(const model::Template &tmpl, uint32_t clip, double time_s, std::vector<float> &positions,
          std::vector<float> &normals)
{
    const model::Level &level = tmpl.levels[0];
    claque::pose::Workspace workspace(tmpl.rig);
    claque::skin::SkinJob job;
    job.level = &level;
    job.palette = workspace.pose(clip, time_s);
    job.morph_weights = workspace.weights();
    job.normals = claque::skin::normals_of(tmpl);
    std::vector<float> scratch(claque::skin::scratch_floats(level, job.palette.count, job.normals));
    job.scratch = claque::base::Span<float>(scratch);
    positions.resize(3 * size_t(level.vertex_count));
    normals.resize(3 * size_t(level.vertex_count));
    job.out_positions = claque::base::Span<float>(positions);
    job.out_normals = claque::base::Span<float>(normals);
    if (const auto status = job.check(); !status.ok()) throw std::runtime_error(status.text);
    job.run();
}

model::Model model_of(const Mesh &mesh, const ZoneMap &map, const std::vector<uint8_t> &keys, model::Wrap wrap)
{
    model::Model made;
    made.name = "torture";
    made.rig.parents.push_back(model::none);
    made.rig.rest.emplace_back();
    made.rig.node_names.emplace_back("root");
    made.rig.palette.emplace_back();
    model::Image image;
    image.width = image.height = map.side;
    image.alpha = model::AlphaMeaning::zone_keys;
    for (const uint16_t zone : map.zones) image.rgba.insert(image.rgba.end(), {200, 210, 220, keys[zone]});
    made.images.push_back(image);
    for (uint32_t i = 0; i < map.zone_count; ++i) {
        model::Zone zone;
        zone.name = "zone " + std::to_string(i);
        zone.key = keys[i];
        made.zones.push_back(zone);
    }
    model::Material material;
    material.image = 0;
    material.wrap_s = material.wrap_t = wrap;
    made.materials.push_back(material);
    model::Part part;
    part.node = 0;
    part.material = 0;
    part.positions = mesh.positions;
    part.normals = mesh.normals;
    part.uvs = mesh.uvs;
    for (const auto &t : mesh.triangles) part.indices.insert(part.indices.end(), t.begin(), t.end());
    part.joints.assign(mesh.positions.size(), 0);
    part.weights.assign(mesh.positions.size(), 1);
    made.parts.push_back(part);
    return made;
}

PosedModel split_posed(const model::Model &source, uint32_t clip, double time_s)
{
    PosedModel posed = split_unwhitened(source, clip, time_s);
    whiten(*posed.tmpl);
    return posed;
}

PosedModel split_unwhitened(const model::Model &source, uint32_t clip, double time_s)
{
    auto tmpl = std::make_unique<model::Template>(std::pmr::get_default_resource());
    claque::meshsplit::build(source, {}, *tmpl);
    PosedModel posed;
    posed.tmpl = std::move(tmpl);
    skin(*posed.tmpl, clip, time_s, posed.positions, posed.normals);
    measure(posed);
    return posed;
}

}  // namespace gltest
