#include "animcache/inspect.h"

#include <algorithm>

#include "lib/pose/pose.h"

namespace claque::animcache
{

Inspection::Inspection(std::pmr::memory_resource *memory, const model::Template &tmpl, VertexFormat vertex_format)
    : vertex_format_(vertex_format), scratch_(memory, 1), vertices_(memory)
{
    const Sizes sizes = sizes_of(tmpl, vertex_format);
    scratch_.reserve(sizes);
    vertices_.resize(sizes.vertex_floats);
}

draw::Pose Inspection::pose(const Request &request)
{
    if (request.key_pose.mode == KeyPoseMode::interpolated) return {};
    const Scratch scratch = scratch_.slice(0);
    const model::Template &tmpl = *request.tmpl;
    math::Affine *palette = reinterpret_cast<math::Affine *>(scratch.palette);
    if (request.palette && request.rigid_mode == RigidMode::matrices) {
        pose::palette_from_locals(tmpl.rig, tmpl.levels[request.level],
                                  reinterpret_cast<const math::Affine *>(request.palette), scratch.globals, palette);
        const float *weights = morph_weights(request.palette, tmpl);
        std::copy_n(weights, tmpl.rig.rest_weights.size(), scratch.palette + (weights - request.palette));
        return {palette, morph_weights(scratch.palette, tmpl)};
    }
    const float *floats = request.palette;
    if (!floats) {
        animate(request, scratch, scratch.palette);
        floats = scratch.palette;
    }
    return {reinterpret_cast<const math::Affine *>(floats), morph_weights(floats, tmpl)};
}

draw::Vertices Inspection::vertices(const Request &request)
{
    const draw::Pose from = pose(request);
    skin(request, reinterpret_cast<const float *>(from.palette), vertex_format_, scratch_.slice(0), vertices_.data());
    return vertices_in(vertices_.data(), *request.tmpl, request.level, vertex_format_, request.blend_radius);
}

}  // namespace claque::animcache
