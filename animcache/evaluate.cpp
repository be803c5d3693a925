#include "animcache/evaluate.h"

#include <algorithm>

#include "lib/pose/pose.h"
#include "lib/skin/skin.h"

namespace claque::animcache
{

namespace
{

constexpr size_t padding = 4;  // floats: SIMD loads of four read past the last matrix

// Morph weights follow the larger of the two sets of matrices.
size_t matrix_floats(const model::Template &tmpl)
{
    return 12 * std::max<size_t>(tmpl.rig.palette.size(), tmpl.rig.node_count());
}

uint32_t count32(size_t n) { return static_cast<uint32_t>(n); }

// Skinning only; rounded so that the data after it is aligned too.
size_t skinning_floats(const model::Template &tmpl, const model::Level &level)
{
    return (skin::scratch_floats(level, tmpl.rig.palette.size(), skin::normals_of(tmpl)) + 7) / 8 * 8;
}

}  // namespace

size_t vertex_floats(const model::Level &level, VertexFormat vertex_format)
{
    constexpr size_t packed_bytes = sizeof(skin::PackedPosition) + sizeof(skin::PackedNormal);
    static_assert(packed_bytes == 3 * sizeof(float), "three floats hold a packed vertex");
    return (vertex_format == VertexFormat::packed ? 3 : 6) * size_t(level.vertex_count) + padding;
}

void Sizes::grow_to(const Sizes &other)
{
    nodes = std::max(nodes, other.nodes);
    palette_floats = std::max(palette_floats, other.palette_floats);
    vertex_floats = std::max(vertex_floats, other.vertex_floats);
    scratch_floats = std::max(scratch_floats, other.scratch_floats);
    spare_floats = std::max(spare_floats, other.spare_floats);
}

Sizes sizes_of(const model::Template &tmpl, VertexFormat vertex_format)
{
    Sizes sizes;
    sizes.nodes = tmpl.rig.node_count();
    sizes.palette_floats = matrix_floats(tmpl) + tmpl.rig.rest_weights.size() + padding;
    sizes.scratch_floats = std::max(sizes.palette_floats, pose::scratch_floats(tmpl.rig, &tmpl.motion));
    for (const model::Level &level : tmpl.levels) {
        sizes.vertex_floats = std::max(sizes.vertex_floats, vertex_floats(level, vertex_format));
        sizes.scratch_floats = std::max(sizes.scratch_floats, skinning_floats(tmpl, level));
    }
    return sizes;
}

Sizes sizes_of(base::Span<const model::Template *const> templates, const Settings &settings)
{
    Sizes sizes;
    for (const model::Template *tmpl : templates) sizes.grow_to(sizes_of(*tmpl, settings.vertex_format));
    if (settings.key_poses.interpolates()) sizes.spare_floats = sizes.vertex_floats;
    return sizes;
}

uint32_t animate(const Request &request, const Scratch &scratch, float *palette)
{
    const model::Rig &rig = request.tmpl->rig;
    pose::PoseJob job;
    job.rig = &rig;
    job.motion = &request.tmpl->motion;
    job.clip = request.pose.clip;
    job.time_s = request.pose.clip_time_s;
    job.layers = request.layers;
    job.dofs = request.dofs;
    job.feet = {request.feet, request.foot_count};
    job.upper = request.upper;
    job.level = &request.tmpl->levels[request.level];
    job.locals = {scratch.locals, rig.node_count()};
    job.globals = {scratch.globals, rig.node_count()};
    job.palette = {reinterpret_cast<math::Affine *>(palette), count32(rig.palette.size())};
    job.weights = {palette + matrix_floats(*request.tmpl), count32(rig.rest_weights.size())};
    job.scratch = {scratch.floats, count32(scratch.sizes->scratch_floats)};
    if (request.rigid_mode == RigidMode::matrices)
        return job.run_local_matrices({reinterpret_cast<math::Affine *>(palette), rig.node_count()});
    job.run();
    return job.level->active.empty() ? rig.node_count() : count32(job.level->nodes.size());
}

const float *morph_weights(const float *palette, const model::Template &tmpl) { return palette + matrix_floats(tmpl); }

void skin(const Request &request, const float *palette, VertexFormat vertex_format, const Scratch &scratch,
          float *vertices)
{
    const model::Template &tmpl = *request.tmpl;
    const model::Level &level = tmpl.levels[request.level];
    skin::SkinJob job;
    job.level = &level;
    job.palette = {reinterpret_cast<const math::Affine *>(palette), count32(tmpl.rig.palette.size())};
    job.morph_weights = {morph_weights(palette, tmpl), count32(tmpl.rig.rest_weights.size())};
    job.normals = skin::normals_of(tmpl);
    job.scratch = {scratch.floats, count32(skinning_floats(tmpl, level))};
    const uint32_t count = level.vertex_count;
    if (vertex_format == VertexFormat::packed) {
        job.range = skin::pack_range(tmpl, request.blend_radius);
        job.out_packed_positions = {reinterpret_cast<skin::PackedPosition *>(vertices), count};
        job.out_packed_normals = {reinterpret_cast<skin::PackedNormal *>(vertices + 2 * size_t(count)), count};
    } else {
        job.out_positions = {vertices, 3 * count};
        job.out_normals = {vertices + 3 * size_t(count), 3 * count};
    }
    job.run();
}

draw::Vertices vertices_in(const float *memory, const model::Template &tmpl, uint32_t level, VertexFormat vertex_format,
                           float blend_radius)
{
    const size_t count = tmpl.levels[level].vertex_count;
    draw::Vertices out;
    if (vertex_format == VertexFormat::floats) {
        out.positions = memory;
        out.normals = memory + 3 * count;
        return out;
    }
    const skin::PackRange range = skin::pack_range(tmpl, blend_radius);
    out.short_positions = reinterpret_cast<const int16_t *>(memory);
    out.byte_normals = reinterpret_cast<const int8_t *>(memory + 2 * count);
    std::copy(range.offset, range.offset + 3, out.offset);
    out.step = range.step;
    return out;
}

}  // namespace claque::animcache
