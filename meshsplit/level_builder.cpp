#include "meshsplit/level_builder.h"

#include <algorithm>

#include "meshsplit/parts.h"

namespace claque::meshsplit
{

namespace
{

void copy_vertices(const Mesh &mesh, model::Level &level)
{
    level.source_count = static_cast<uint32_t>(mesh.vertices.size());
    level.positions.reserve(3 * mesh.vertices.size());
    level.normals.reserve(3 * mesh.vertices.size());
    for (const MeshVertex &vertex : mesh.vertices) {
        for (int k = 0; k < 3; ++k) level.positions.push_back(vertex.position[k]);
        for (int k = 0; k < 3; ++k) level.normals.push_back(vertex.normal[k]);
    }
}

void copy_influences(const Mesh &mesh, model::Level &level)
{
    for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        const MeshVertex &vertex = mesh.vertices[v];
        if (level.runs.empty() || level.runs.back().influences != vertex.influence_count)
            level.runs.push_back({v, 0, vertex.influence_count, static_cast<uint32_t>(level.joints.size())});
        ++level.runs.back().count;
        for (uint32_t i = 0; i < vertex.influence_count; ++i) {
            const Influence &influence = mesh.influences[vertex.first_influence + i];
            level.joints.push_back(static_cast<uint16_t>(influence.joint));
            level.weights.push_back(influence.weight);
        }
    }
}

struct PlacedDelta {
    uint32_t weight;
    model::MorphDelta delta;
};

// Ranges are sorted by weight, and within a range by vertex.
void copy_morphs(const Mesh &mesh, model::Level &level)
{
    std::vector<PlacedDelta> placed;
    for (uint32_t v = 0; v < mesh.vertices.size(); ++v)
        for (uint32_t m = 0; m < mesh.vertices[v].morph_count; ++m) {
            const VertexMorph &morph = mesh.morphs[mesh.vertices[v].first_morph + m];
            model::MorphDelta delta;
            delta.vertex = v;
            for (int k = 0; k < 3; ++k) delta.position[k] = morph.position[k], delta.normal[k] = morph.normal[k];
            placed.push_back({morph.weight, delta});
        }
    std::stable_sort(placed.begin(), placed.end(),
                     [](const PlacedDelta &a, const PlacedDelta &b) { return a.weight < b.weight; });
    for (const PlacedDelta &p : placed) {
        if (level.morph_ranges.empty() || level.morph_ranges.back().weight != p.weight)
            level.morph_ranges.push_back({p.weight, static_cast<uint32_t>(level.morph_deltas.size()), 0});
        level.morph_deltas.push_back(p.delta);
        ++level.morph_ranges.back().count;
    }
}

// Copies UVs and colours of all vertices, including copies.
void copy_attributes(const Mesh &mesh, model::Level &level)
{
    for (uint32_t v = 0; v < level.vertex_count; ++v) {
        const MeshVertex &vertex = mesh.vertices[v < level.source_count ? v : level.copies[v - level.source_count]];
        level.uvs.push_back(vertex.uv.x);
        level.uvs.push_back(vertex.uv.y);
        if (mesh.has_colours) level.colours.insert(level.colours.end(), vertex.colour.begin(), vertex.colour.end());
    }
}

}  // namespace

void build_level(Mesh &mesh, const TriangleZones &zones, const model::Rig &rig, model::Level &out)
{
    const uint32_t part_count = number_parts(mesh);
    copy_vertices(mesh, out);
    copy_influences(mesh, out);
    copy_morphs(mesh, out);
    make_streams(mesh, zones, part_count, out);
    copy_attributes(mesh, out);
    make_parts(mesh, part_count, rig, out);
    model::plan_skinning(out);
}

void set_skeletons(const std::vector<const std::vector<uint8_t> *> &active, size_t entry_count,
                   model::Array<model::Level> &levels)
{
    // Nodes only stop with distance, so levels with equal skeletons are adjacent. If all are equal, every level has the
    // whole skeleton.
    if (*active.front() == *active.back()) return;
    for (uint32_t first = 0, last; first < levels.size(); first = last) {
        std::vector<uint8_t> used(entry_count);
        for (last = first; last < levels.size() && *active[last] == *active[first]; ++last)
            for (const uint16_t entry : levels[last].joints) used[entry] = 1;
        for (uint32_t k = first; k < last; ++k) {
            levels[k].skeletal_level = first;
            levels[k].active.assign(active[k]->begin(), active[k]->end());
            for (uint32_t i = 0; i < active[k]->size(); ++i)
                if ((*active[k])[i]) levels[k].nodes.push_back(i);
            for (uint32_t e = 0; e < entry_count; ++e)
                if (used[e]) levels[k].entries.push_back(e);
        }
    }
}

}  // namespace claque::meshsplit
