// Makes a flyer's pieces parts of a Model. All levels of all pieces share one texture: charts are unwrapped over all
// levels, and each texel is painted at its position on the finest level that covers it.
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "lib/figures/ambient_occlusion.h"
#include "lib/figures/flyer/flyer.h"

namespace claque::figures::flyer
{

namespace
{

struct Block {
    const Piece *piece = nullptr;
    int level = 0;
    float first_m = 0, last_m = 0;
    Mesh mesh;
};

std::vector<Block> blocks_of(const std::vector<Piece> &pieces)
{
    std::vector<Block> blocks;
    for (const Piece &piece : pieces) {
        float from = piece.first_m;
        for (size_t level = 0; level < piece.ends_m.size(); ++level) {
            Block block;
            block.piece = &piece;
            block.level = static_cast<int>(level);
            block.first_m = from, block.last_m = from = piece.ends_m[level];
            piece.shape(block.mesh, block.level);
            blocks.push_back(block);
        }
    }
    return blocks;
}

void append(Mesh &all, const Mesh &mesh)
{
    const uint32_t base = static_cast<uint32_t>(all.points.size());
    all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
    for (Face face : mesh.faces) {
        for (Corner &corner : face.corners) corner.point += base;
        all.faces.push_back(face);
    }
}

// Coarse before fine, so that the finest surface is painted last.
Mesh unwrapped(std::vector<Block> &blocks, const Layout &layout)
{
    Mesh all;
    std::vector<Block *> order;
    for (int level = 8; level >= 0; --level)
        for (Block &block : blocks)
            if (block.level == level) order.push_back(&block);
    for (const Block *block : order) append(all, block->mesh);
    unwrap(all, layout);
    size_t face = 0;
    for (Block *block : order)
        for (Face &own : block->mesh.faces) {
            for (size_t k = 0; k < 3; ++k) own.corners[k].uv = all.faces[face].corners[k].uv;
            ++face;
        }
    return all;
}

// One vertex for each pair of point and texture position. Normals are those of the point, so that seams do not show.
model::Part part_of(const Block &block, const Joints &joints)
{
    const std::vector<glm::vec3> normals = block.mesh.smooth_normals();
    const uint32_t node = static_cast<uint32_t>(block.piece->node);
    model::Part part;
    part.name = block.piece->name;
    part.node = node;
    part.material = 0;
    part.lod_min_m = block.first_m, part.lod_max_m = block.last_m;
    std::map<std::tuple<uint32_t, float, float>, uint32_t> made;
    for (const Face &face : block.mesh.faces)
        for (const Corner &corner : face.corners) {
            const auto [at, fresh] = made.try_emplace({corner.point, corner.uv.x, corner.uv.y},
                                                      static_cast<uint32_t>(part.positions.size()));
            part.indices.push_back(at->second);
            if (!fresh) continue;
            part.positions.push_back(block.mesh.points[corner.point].position - joints[node].at);
            part.normals.push_back(normals[corner.point]);
            part.uvs.push_back(corner.uv);
        }
    part.joints.assign(part.positions.size(), node);
    part.weights.assign(part.positions.size(), 1.0f);
    return part;
}

// True for nodes that move too far to leave a shadow at their rest position.
bool sweeps(Node node)
{
    return node == Node::wing_left || node == Node::wing_right || node == Node::arm_left || node == Node::arm_right;
}

}  // namespace

model::Model assemble(const Flyer &flyer)
{
    std::vector<Block> blocks = blocks_of(flyer.pieces);
    const Mesh all = unwrapped(blocks, flyer.layout);
    Mesh near;
    for (const Block &block : blocks)
        if (block.first_m == 0 && !sweeps(block.piece->node)) append(near, block.mesh);
    const AmbientOcclusion occlusion(near);
    model::Model model;
    model.name = flyer.name;
    add_nodes(model.rig, flyer.joints);
    add_clips(model.rig, flyer.joints, flyer.flight_style);
    model.zones = zones_of(flyer.zones);
    // Evaluated slightly off the surface, so that flat faces with smooth normals do not occlude themselves.
    model.images = paint(
        all, [&](glm::vec3 p, glm::vec3 n) { return occlusion.ambient_visibility(p + n * 0.015f, n); }, {flyer.painter},
        flyer.zones);
    model.images[0].name = flyer.name;
    model::Material material;
    material.name = flyer.name;
    material.image = 0;
    material.wrap_s = material.wrap_t = model::Wrap::clamp;
    model.materials.push_back(material);
    for (const Block &block : blocks) model.parts.push_back(part_of(block, flyer.joints));
    model::check(model);
    return model;
}

}  // namespace claque::figures::flyer
