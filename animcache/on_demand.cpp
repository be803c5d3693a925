#include "animcache/on_demand.h"

#include <algorithm>

#include "animcache/keypose_vertices.h"

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
    request.placement = Placement::vertices;
    const Scratch scratch = scratch_.strand(0);
    const Geometry geometry = caches_->settings().geometry;
    if (request.shared.method == Method::interpolated) {
        interpolate(request, geometry, scratch, vertices_.data());
        return vertices_in(vertices_.data(), *request.tmpl, request.level, geometry);
    }
    const float *palette = caches_->palette_of(item.actor_index);
    if (!palette) {
        animate(request, scratch, scratch.palette);
        palette = scratch.palette;
    }
    skin(request, palette, geometry, scratch, vertices_.data());
    return vertices_in(vertices_.data(), *request.tmpl, request.level, geometry, request.blend_radius);
}

}  // namespace claque::animcache
