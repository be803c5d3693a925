#include "animcache/on_demand.h"

#include <algorithm>

namespace claque::animcache
{

void OnDemand::reserve(base::Span<const model::Template *const> templates, Geometry geometry)
{
    Sizes sizes;
    for (const model::Template *tmpl : templates) sizes.grow_to(sizes_of(*tmpl, geometry));
    scratch_.reserve(sizes);
    if (vertices_.size() < sizes.vertex_floats) vertices_.resize(sizes.vertex_floats);
}

draw::Vertices OnDemand::serve(const draw::Item &item)
{
    Request request = caches_->request_of(item.actor_index);
    request.placement = Placement::vertices;
    const Scratch scratch = scratch_.strand(0);
    const float *palette = caches_->palette_of(item.actor_index);
    if (!palette) {
        animate(request, scratch, scratch.palette);
        palette = scratch.palette;
    }
    const Geometry geometry = caches_->settings().geometry;
    skin(request, palette, geometry, scratch, vertices_.data());
    return vertices_in(vertices_.data(), *request.tmpl, request.level, geometry);
}

}  // namespace claque::animcache
