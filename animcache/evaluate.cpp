#include "animcache/evaluate.h"

#include <algorithm>

#include "lib/pose/pose.h"
#include "lib/skin/skin.h"

namespace claque::animcache
{

namespace
{

constexpr size_t padding = 4;  // floats: loads of four run over the last matrix

// Morph weights lie behind whichever matrices are more.
size_t matrix_floats(const model::Template &tmpl)
{
    return 12 * std::max<size_t>(tmpl.rig.palette.size(), tmpl.rig.node_count());
}

uint32_t count32(size_t n) { return static_cast<uint32_t>(n); }

}  // namespace

void Sizes::grow_to(const Sizes &other)
{
    nodes = std::max(nodes, other.nodes);
    palette_floats = std::max(palette_floats, other.palette_floats);
    vertex_floats = std::max(vertex_floats, other.vertex_floats);
    scratch_floats = std::max(scratch_floats, other.scratch_floats);
}

Sizes sizes_of(const model::Template &tmpl)
{
    Sizes sizes;
    sizes.nodes = tmpl.rig.node_count();
    sizes.palette_floats = matrix_floats(tmpl) + tmpl.rig.rest_weights.size() + padding;
    sizes.scratch_floats = sizes.palette_floats;
    for (const model::Level &level : tmpl.levels) {
        sizes.vertex_floats = std::max(sizes.vertex_floats, 6 * size_t(level.vertex_count) + padding);
        sizes.scratch_floats = std::max(sizes.scratch_floats,
                                        skin::scratch_floats(level, tmpl.rig.palette.size(), skin::normals_of(tmpl)));
    }
    return sizes;
}

uint32_t animate(const Request &request, const Scratch &scratch, float *palette)
{
    const model::Rig &rig = request.tmpl->rig;
    pose::PoseJob job;
    job.rig = &rig;
    job.clip = request.pose.clip;
    job.time_s = request.pose.clip_time_s;
    job.dofs = request.dofs;
    job.level = &request.tmpl->levels[request.level];
    job.locals = {scratch.locals, rig.node_count()};
    job.globals = {scratch.globals, rig.node_count()};
    job.palette = {reinterpret_cast<math::Affine *>(palette), count32(rig.palette.size())};
    job.weights = {palette + matrix_floats(*request.tmpl), count32(rig.rest_weights.size())};
    if (request.placement == Placement::matrices)
        return job.run_locals({reinterpret_cast<math::Affine *>(palette), rig.node_count()});
    job.run();
    return job.level->active.empty() ? rig.node_count() : count32(job.level->nodes.size());
}

void skin(const Request &request, const float *palette, const Scratch &scratch, float *vertices)
{
    const model::Template &tmpl = *request.tmpl;
    const model::Level &level = tmpl.levels[request.level];
    skin::SkinJob job;
    job.level = &level;
    job.palette = {reinterpret_cast<const math::Affine *>(palette), count32(tmpl.rig.palette.size())};
    job.morph_weights = {palette + matrix_floats(tmpl), count32(tmpl.rig.rest_weights.size())};
    job.normals = skin::normals_of(tmpl);
    job.scratch = {scratch.floats, count32(scratch.sizes->scratch_floats)};
    job.out_positions = {vertices, 3 * level.vertex_count};
    job.out_normals = {vertices + 3 * size_t(level.vertex_count), 3 * level.vertex_count};
    job.run();
}

draw::Vertices vertices_in(const float *memory, const model::Level &level)
{
    return {memory, memory + 3 * size_t(level.vertex_count)};
}

}  // namespace claque::animcache
