#include "animcache/on_demand.h"

#include <algorithm>

#include "animcache/keypose_vertices.h"
#include "lib/pose/pose.h"

namespace claque::animcache
{

void OnDemand::reserve(base::Span<const model::Template *const> templates, const Settings &settings)
{
    const Sizes sizes = sizes_of(templates, settings);
    scratch_.reserve(sizes);
    if (vertices_.size() < sizes.vertex_floats) vertices_.resize(sizes.vertex_floats);
}

draw::Vertices OnDemand::serve(const draw::Item &item)
{
    Request request = caches_->request_of(item.actor_index);
    request.rigid_mode = RigidMode::vertices;
    const Scratch scratch = scratch_.slice(0);
    const VertexFormat vertex_format = caches_->settings().vertex_format;
    if (request.key_pose.mode == KeyPoseMode::interpolated) {
        interpolate(request, vertex_format, scratch, vertices_.data());
        return vertices_in(vertices_.data(), *request.tmpl, request.level, vertex_format);
    }
    const float *palette = caches_->palette_of(item.actor_index);
    if (!palette) {
        animate(request, scratch, scratch.palette);
        palette = scratch.palette;
    }
    skin(request, palette, vertex_format, scratch, vertices_.data());
    return vertices_in(vertices_.data(), *request.tmpl, request.level, vertex_format, request.blend_radius);
}

draw::Pose OnDemand::pose(const draw::Item &item)
{
    Request request = caches_->request_of(item.actor_index);
    if (request.key_pose.mode == KeyPoseMode::interpolated) return {};
    const Scratch scratch = scratch_.slice(0);
    const float *palette = caches_->palette_of(item.actor_index);
    if (const math::Affine *locals = caches_->locals_of(item.actor_index)) {
        const model::Template &tmpl = *request.tmpl;
        pose::palette_from_locals(tmpl.rig, tmpl.levels[request.level], locals, scratch.globals,
                                  reinterpret_cast<math::Affine *>(scratch.palette));
        return {reinterpret_cast<const math::Affine *>(scratch.palette), morph_weights(palette, tmpl)};
    }
    // A key-pose that is kept was skinned for others, and whatever palette there is belongs to another moment.
    if (!palette || !request.needs_palette()) {
        request.rigid_mode = RigidMode::vertices;
        animate(request, scratch, scratch.palette);
        palette = scratch.palette;
    }
    return {reinterpret_cast<const math::Affine *>(palette), morph_weights(palette, *request.tmpl)};
}

}  // namespace claque::animcache
