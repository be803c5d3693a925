// The split meshes of a template, for renderers other than claque's.
#include <claque/mesh.h>

#include <algorithm>
#include <cstddef>

#include "lib/api/boundary.h"
#include "lib/api/handles.h"

using namespace claque;

namespace
{

static_assert(sizeof(clq_morph_delta) == sizeof(model::MorphDelta) &&
                  offsetof(clq_morph_delta, position) == offsetof(model::MorphDelta, position) &&
                  offsetof(clq_morph_delta, normal) == offsetof(model::MorphDelta, normal),
              "hosts read the template's own deltas");

const model::Level &level_of(const clq_template *tmpl, uint32_t level)
{
    api::require(tmpl != nullptr, "tmpl is NULL");
    if (level >= tmpl->levels.size())
        base::fail(CLQ_ARGUMENT, "level %u does not exist: '%s' has %zu", level, tmpl->name.c_str(),
                   tmpl->levels.size());
    return tmpl->levels[level];
}

uint32_t bins_of(const model::Surface &surface)
{
    return static_cast<uint32_t>(surface.clean.size()) + (surface.dirty.count != 0);
}

uint32_t most_influences(const model::Level &level)
{
    uint32_t maximum = 0;
    for (const model::InfluenceRun &run : level.runs) maximum = std::max(maximum, run.influences);
    return maximum;
}

}  // namespace

extern "C" {

clq_status clq_template_get_mesh(const clq_template *tmpl, uint32_t level, clq_mesh *out)
{
    return api::boundary("clq_template_get_mesh", [&] {
        const model::Level &from = level_of(tmpl, level);
        api::require(out != nullptr, "out is NULL");
        api::require_size(*out, "clq_mesh_init");
        clq_mesh mesh = clq_mesh_init();
        mesh.vertex_count = from.source_count;
        mesh.positions = from.positions.data();
        mesh.normals = from.normals.data();
        mesh.uvs = from.uvs.data();
        mesh.colours = from.colours.empty() ? nullptr : from.colours.data();
        mesh.influence_count = most_influences(from);
        for (const model::Surface &surface : from.surfaces) mesh.bin_count += bins_of(surface);
        mesh.morph_count = static_cast<uint32_t>(from.morph_ranges.size());
        mesh.normals_by_inverse = !tmpl->similar_only;
        api::write_out(out, mesh);
    });
}

clq_status clq_template_get_triangles(const clq_template *tmpl, uint32_t level, uint32_t bin, clq_triangles *out)
{
    return api::boundary("clq_template_get_triangles", [&] {
        const model::Level &from = level_of(tmpl, level);
        api::require(out != nullptr, "out is NULL");
        api::require_size(*out, "clq_triangles_init");
        uint32_t left = bin;
        for (const model::Surface &surface : from.surfaces) {
            const uint32_t count = bins_of(surface);
            if (left >= count) {
                left -= count;
                continue;
            }
            const bool clean = left < surface.clean.size();
            const model::IndexRange range = clean ? surface.clean[left].range : surface.dirty;
            clq_triangles triangles = clq_triangles_init();
            triangles.texture = surface.texture;
            triangles.double_sided = surface.double_sided;
            triangles.zone =
                clean ? tmpl->textures[surface.texture].keys[surface.clean[left].zone_index].zone : CLQ_NONE;
            triangles.index_count = range.count;
            triangles.indices = from.indices.data() + range.first;
            triangles.unlit = surface.lighting.unlit;
            std::copy_n(surface.lighting.emission.begin(), 3, triangles.emission);
            api::write_out(out, triangles);
            return;
        }
        base::fail(CLQ_ARGUMENT, "bin %u of level %u does not exist: there '%s' has %u", bin, level, tmpl->name.c_str(),
                   bin - left);
    });
}

clq_status clq_template_get_morph_target(const clq_template *tmpl, uint32_t level, uint32_t target,
                                         clq_morph_target *out)
{
    return api::boundary("clq_template_get_morph_target", [&] {
        const model::Level &from = level_of(tmpl, level);
        api::require(out != nullptr, "out is NULL");
        api::require_size(*out, "clq_morph_target_init");
        if (target >= from.morph_ranges.size())
            base::fail(CLQ_ARGUMENT, "morph target %u of level %u does not exist: there '%s' has %zu", target, level,
                       tmpl->name.c_str(), from.morph_ranges.size());
        const model::MorphRange &range = from.morph_ranges[target];
        clq_morph_target found = clq_morph_target_init();
        found.weight = range.weight;
        found.delta_count = range.count;
        found.deltas = reinterpret_cast<const clq_morph_delta *>(from.morph_deltas.data() + range.first);
        api::write_out(out, found);
    });
}

clq_status clq_template_get_influences(const clq_template *tmpl, uint32_t level, const clq_influences *out)
{
    return api::boundary("clq_template_get_influences", [&] {
        const model::Level &from = level_of(tmpl, level);
        api::require(out != nullptr, "out is NULL");
        const clq_influences wanted = api::read_def(out, clq_influences_init, "clq_influences_init");
        api::require(wanted.joints && wanted.weights, "joints or weights is NULL");
        const uint32_t per_vertex = wanted.per_vertex;
        if (per_vertex < most_influences(from))
            base::fail(CLQ_ARGUMENT, "%u influences a vertex of level %u of '%s', where one has %u", per_vertex, level,
                       tmpl->name.c_str(), most_influences(from));
        if (wanted.capacity / std::max(per_vertex, 1u) < from.source_count)
            base::fail(CLQ_ARGUMENT, "room for %zu influences, %u each of %u vertices", wanted.capacity, per_vertex,
                       from.source_count);
        std::fill_n(wanted.joints, size_t(per_vertex) * from.source_count, uint16_t(0));
        std::fill_n(wanted.weights, size_t(per_vertex) * from.source_count, 0.0f);
        for (const model::InfluenceRun &run : from.runs)
            for (uint32_t v = 0; v < run.count; ++v) {
                const size_t source = run.first_influence + size_t(v) * run.influences;
                const size_t place = size_t(run.first + v) * per_vertex;
                std::copy_n(from.joints.data() + source, run.influences, wanted.joints + place);
                std::copy_n(from.weights.data() + source, run.influences, wanted.weights + place);
            }
    });
}

clq_status clq_template_get_wrap(const clq_template *tmpl, uint32_t texture, clq_wrap *out_s, clq_wrap *out_t)
{
    return api::boundary("clq_template_get_wrap", [&] {
        api::require(tmpl && out_s && out_t, "tmpl, out_s or out_t is NULL");
        if (texture >= tmpl->textures.size())
            base::fail(CLQ_ARGUMENT, "texture %u does not exist: '%s' has %zu", texture, tmpl->name.c_str(),
                       tmpl->textures.size());
        const auto wrap = [](model::Wrap from) {
            return from == model::Wrap::clamp ? CLQ_WRAP_CLAMP : CLQ_WRAP_REPEAT;
        };
        *out_s = wrap(tmpl->textures[texture].wrap_s);
        *out_t = wrap(tmpl->textures[texture].wrap_t);
    });
}

}  // extern "C"
