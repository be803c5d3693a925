// The pose and vertices of individuals as the last update of a view left them. GL's matrix stack may place their parts:
// then they are skinned here.
#pragma once

#include <new>
#include <optional>

#include "animcache/inspect.h"
#include "lib/api/crowd_handle.h"
#include "lib/draw/vertex_source.h"

namespace claque::api
{

// Results are valid until the next call. Calls throw std::bad_alloc, also for an individual that the update left out
// for lack of memory.
class Inspected
{
public:
    explicit Inspected(const clq_view *view) : view_(view) {}

    draw::Vertices vertices(const draw::Item &item)
    {
        return item.vertices.any() ? item.vertices : inspection_of(item).vertices(request_of(item));
    }
    // Null palette: the individual shows two key-poses blended.
    draw::Pose pose(const draw::Item &item)
    {
        return item.pose.palette ? item.pose : inspection_of(item).pose(request_of(item));
    }

private:
    const animcache::Request &request_of(const draw::Item &item) const { return view_->crowd->frame.request_of(item); }
    animcache::Inspection &inspection_of(const draw::Item &item)
    {
        if (!item.vertices.any() && !item.locals) throw std::bad_alloc();  // left out by the update
        const clq_crowd &crowd = *view_->crowd;
        return inspection_.emplace(&crowd.context->memory, *item.tmpl, crowd.frame.settings().caches.vertex_format);
    }

    const clq_view *view_;
    std::optional<animcache::Inspection> inspection_;
};

class InspectedSource final : public draw::VertexSource
{
public:
    explicit InspectedSource(const clq_view *view) : inspected_(view) {}
    draw::Vertices vertices_of(const draw::Item &item) noexcept override
    try {
        return inspected_.vertices(item);
    } catch (const std::exception &) {
        return {};
    }

private:
    Inspected inspected_;
};

}  // namespace claque::api
