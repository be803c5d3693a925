#include "meshsplit/build.h"

#include "lib/base/error.h"
#include "meshsplit/rest.h"
#include "meshsplit/spheres.h"
#include "meshsplit/streams.h"
#include "meshsplit/textures.h"

#include <algorithm>

namespace claque::meshsplit
{

namespace
{

void copy_zones(const Looks &looks, model::Template &out)
{
    for (const model::Zone &zone : looks.zones) {
        out.zone_names.emplace_back(std::string_view(zone.name));
        out.zone_colours.push_back(zone.colour);
        out.zone_ranges.push_back(zone.range);
    }
}

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

// Ranges by weight, within one by vertex.
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

// UVs and colours of all vertices, copies included.
void copy_looks(const Mesh &mesh, model::Level &level)
{
    for (uint32_t v = 0; v < level.vertex_count; ++v) {
        const MeshVertex &vertex = mesh.vertices[v < level.source_count ? v : level.copies[v - level.source_count]];
        level.uvs.push_back(vertex.uv.x);
        level.uvs.push_back(vertex.uv.y);
        if (mesh.has_colours) level.colours.insert(level.colours.end(), vertex.colour.begin(), vertex.colour.end());
    }
}

void report(const Mesh &mesh, const TriangleZones &zones, model::Template &out)
{
    model::SplitReport &r = out.report;
    r.triangles = static_cast<uint32_t>(mesh.triangles.size());
    r.degenerate = mesh.degenerate;
    r.coincident = mesh.coincident;
    r.copies = static_cast<uint32_t>(out.levels[0].copies.size());
    out.zone_clean.assign(out.zone_names.size(), 0);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const uint32_t count = zones.count(t);
        r.fused_triangles += count;
        if (count > 1) ++r.dirty, r.dirty_zone_sum += count;
        const model::Texture &texture = out.textures[mesh.surfaces[mesh.triangles[t].surface].texture];
        if (count == 1) ++out.zone_clean[texture.keys[zones.of(t)[0]].zone];
    }
}

uint32_t texture_limit(uint32_t wanted)
{
    if (wanted == 0) base::fail(CLQ_ARGUMENT, "a largest texture size of 0 texels");
    uint32_t p = 1;
    while (p <= wanted / 2 && p < 16384) p *= 2;
    return p;
}

}  // namespace

void build(const model::Model &model, const BuildOptions &options, model::Template &out)
{
    model::check(model);
    if (model.rig.palette.size() > 65536)
        base::fail(CLQ_LIMIT, "model '%s' has %zu joints: a template takes 65536", model.name.c_str(),
                   model.rig.palette.size());
    const Looks looks = plan_looks(model);
    Mesh mesh = merge(model, looks);
    if (mesh.triangles.empty())
        base::fail(CLQ_ARGUMENT, "model '%s' has no triangle to draw: %zu parts, %u triangles without area",
                   model.name.c_str(), model.parts.size(), mesh.degenerate);

    std::pmr::memory_resource *memory = out.levels.get_allocator().resource();
    out.name = model.name;
    out.rig = model::Rig(model.rig, memory);
    out.similar_only = similar_only(model.rig);
    copy_zones(looks, out);
    make_textures(model, looks, texture_limit(options.max_texture_px), mesh, out.textures);

    const TriangleZones zones = zones_of_triangles(mesh, out.textures);
    out.levels.emplace_back(memory);
    model::Level &level = out.levels.back();
    copy_vertices(mesh, level);
    copy_influences(mesh, level);
    copy_morphs(mesh, level);
    make_streams(mesh, zones, level);
    copy_looks(mesh, level);
    report(mesh, zones, out);
    out.sklsroot = enclosing_sphere(out);
}

}  // namespace claque::meshsplit
