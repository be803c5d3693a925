#include "lib/lod/decimation/decimated_parts.h"

#include <algorithm>
#include <map>

namespace claque::lod
{

namespace
{

int8_t orientation_of(const WeldedSurface &surface, const std::array<uint32_t, 3> &corners)
{
    const glm::dvec2 a(surface.uv(corners[0])), b(surface.uv(corners[1])), c(surface.uv(corners[2]));
    const double turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return static_cast<int8_t>((turn > 0) - (turn < 0));
}

// Copies the influences of one vertex between parts whose influence counts may differ.
void copy_influences(const model::Part &from, uint32_t v, model::Part &to)
{
    float sum = 0;
    for (uint32_t k = 0; k < to.influence_count; ++k) {
        const bool has = k < from.influence_count;
        to.joints.push_back(has ? from.joints[size_t(v) * from.influence_count + k] : 0);
        to.weights.push_back(has ? from.weights[size_t(v) * from.influence_count + k] : 0);
        sum += to.weights.back();
    }
    if (from.influence_count <= to.influence_count) return;
    for (size_t i = to.weights.size() - to.influence_count; i < to.weights.size(); ++i)
        to.weights[i] = sum > 0 ? to.weights[i] / sum : 1.0f / float(to.influence_count);
}

void copy_vertex(const WeldedSurface &surface, const LevelVertex &vertex, model::Part &to)
{
    const model::Part &attributes = surface.part(surface.part_of(vertex.attribute_corner));
    const model::Part &source = surface.part(surface.part_of(vertex.position_corner));
    const uint32_t i = surface.vertex_of(vertex.attribute_corner), v = surface.vertex_of(vertex.position_corner);
    if (!attributes.normals.empty()) to.normals.push_back(attributes.normals[i]);
    if (!attributes.uvs.empty()) to.uvs.push_back(attributes.uvs[i]);
    if (!attributes.colours.empty()) to.colours.push_back(attributes.colours[i]);
    to.positions.push_back(source.positions[v]);
    copy_influences(source, v, to);
    for (size_t m = 0; m < attributes.morphs.size(); ++m) {
        const bool own = &attributes == &source;
        if (!attributes.morphs[m].positions.empty())
            to.morphs[m].positions.push_back(own ? source.morphs[m].positions[v] : glm::vec3(0));
        if (!attributes.morphs[m].normals.empty())
            to.morphs[m].normals.push_back(own ? source.morphs[m].normals[v] : glm::vec3(0));
    }
}

model::Part head_of(const model::Part &from)
{
    model::Part to;
    to.name = from.name, to.node = from.node, to.skinned = from.skinned, to.material = from.material;
    to.hidden = from.hidden, to.influence_count = from.influence_count, to.morph_set = from.morph_set;
    to.lod_min_m = from.lod_min_m, to.lod_max_m = from.lod_max_m;
    to.morphs.resize(from.morphs.size());
    return to;
}

// Maps each vertex to the coarsest level that uses it.
using Ranks = std::map<LevelVertex, uint32_t>;

Decimated build_decimated_level(const WeldedSurface &surface, size_t part_count, const LevelTriangles &remaining,
                                const Ranks &ranks)
{
    Decimated out;
    out.triangles = remaining.triangles.size(), out.flipped = remaining.flipped,
    out.non_manifold_triangles = surface.non_manifold_triangles;
    for (uint32_t i = 0; i < part_count; ++i) out.parts.push_back(head_of(surface.part(i)));
    out.source_vertices.resize(part_count);
    std::vector<std::pair<uint32_t, LevelVertex>> used;
    for (const auto &t : remaining.triangles)
        for (const LevelVertex &vertex : t) used.push_back({ranks.at(vertex), vertex});
    std::sort(used.begin(), used.end(), [](const auto &a, const auto &b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::map<LevelVertex, uint32_t> renamed;
    for (const auto &[rank, vertex] : used) {
        model::Part &part = out.parts[surface.part_of(vertex.attribute_corner)];
        renamed[vertex] = static_cast<uint32_t>(part.positions.size());
        copy_vertex(surface, vertex, part);
        out.source_vertices[surface.part_of(vertex.attribute_corner)].push_back(
            surface.vertex_of(vertex.attribute_corner));
    }
    for (const auto &t : remaining.triangles)
        for (const LevelVertex &vertex : t)
            out.parts[surface.part_of(t[0].attribute_corner)].indices.push_back(renamed.at(vertex));
    return out;
}

}  // namespace

UvOrientations::UvOrientations(const WeldedSurface &surface)
{
    for (const Mesh::FaceHandle face : surface.mesh.faces())
        orientations_.push_back(surface.has_uv(surface.mesh.property(surface.corners, face).corner[0])
                                    ? orientation_of(surface, surface.mesh.property(surface.corners, face).corner)
                                    : int8_t(0));
}

bool UvOrientations::flipped(const WeldedSurface &surface, Mesh::FaceHandle face,
                             const std::array<uint32_t, 3> &corners) const
{
    return orientations_[static_cast<size_t>(face.idx())] * orientation_of(surface, corners) < 0;
}

std::vector<Decimated> build_decimated(const WeldedSurface &surface, size_t part_count,
                                       const std::vector<LevelTriangles> &levels)
{
    Ranks ranks;
    for (uint32_t level = 0; level < levels.size(); ++level)
        for (const auto &t : levels[level].triangles)
            for (const LevelVertex &vertex : t) ranks[vertex] = level;
    std::vector<Decimated> out;
    for (const LevelTriangles &level : levels) out.push_back(build_decimated_level(surface, part_count, level, ranks));
    return out;
}

}  // namespace claque::lod
