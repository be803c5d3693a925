// Cameras and views.
#include <claque/view.h>

#include <algorithm>
#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/camera_def.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/scene_handle.h"

using namespace claque;

namespace claque::api
{

frame::Camera camera_of(const clq_camera &camera)
{
    frame::Camera wanted;
    wanted.eye = glm::dvec3(camera.eye[0], camera.eye[1], camera.eye[2]);
    const float *q = camera.rotation_xyzw;
    wanted.rotation = glm::quat(q[3], q[0], q[1], q[2]);
    bool finite = std::isfinite(wanted.eye.x) && std::isfinite(wanted.eye.y) && std::isfinite(wanted.eye.z);
    for (int k = 0; k < 16; ++k) {
        wanted.projection[k] = camera.projection[k];
        finite = finite && std::isfinite(camera.projection[k]);
    }
    require(finite, "the eye or the projection is not finite");
    const float length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (!(std::fabs(length - 1) <= 2e-3f))
        base::fail(CLQ_ARGUMENT, "the camera's rotation has length %g: a unit quaternion is wanted",
                   std::sqrt(static_cast<double>(length)));
    return wanted;
}

}  // namespace claque::api

extern "C" {

clq_status clq_camera_look_at(const clq_look_at_def *def, clq_camera *out)
{
    return api::boundary("clq_camera_look_at", [&] {
        api::require(def && out, "def or out is NULL");
        const clq_look_at_def d = api::read_def(def, clq_look_at_def_init, "clq_look_at_def_init");
        const frame::Camera made =
            frame::look_at(glm::dvec3(d.eye[0], d.eye[1], d.eye[2]), glm::dvec3(d.target[0], d.target[1], d.target[2]),
                           glm::vec3(d.up[0], d.up[1], d.up[2]), d.fov_y_rad, d.aspect, d.z_near, d.z_far);
        for (int k = 0; k < 3; ++k) out->eye[k] = made.eye[k];
        out->rotation_xyzw[0] = made.rotation.x, out->rotation_xyzw[1] = made.rotation.y;
        out->rotation_xyzw[2] = made.rotation.z, out->rotation_xyzw[3] = made.rotation.w;
        std::copy(made.projection, made.projection + 16, out->projection);
    });
}

clq_status clq_view_create(clq_crowd *crowd, clq_view **out)
{
    return api::boundary("clq_view_create", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        const api::Busy busy(crowd);
        crowd->views.reserve(crowd->views.size() + 1);
        base::HostMemory &memory = crowd->context->memory;
        void *place = memory.allocate(sizeof(clq_view), alignof(clq_view));
        try {
            crowd->views.push_back(new (place) clq_view(crowd));
        } catch (...) {
            memory.deallocate(place, sizeof(clq_view), alignof(clq_view));
            throw;
        }
        *out = crowd->views.back();
    });
}

clq_status clq_view_destroy(clq_view *view)
{
    return api::boundary("clq_view_destroy", [&] {
        if (!view) return;
        clq_crowd *crowd = view->crowd;
        const api::Busy busy(crowd);
        crowd->views.erase(std::remove(crowd->views.begin(), crowd->views.end(), view), crowd->views.end());
        for (clq_scene *scene : crowd->scenes) scene->scene.forget_view(view);
        view->~clq_view();
        crowd->context->memory.deallocate(view, sizeof(clq_view), alignof(clq_view));
    });
}

clq_status clq_view_set_camera(clq_view *view, const clq_camera *camera)
{
    return api::boundary("clq_view_set_camera", [&] {
        api::require(view && camera, "view or camera is NULL");
        const api::Busy busy(view->crowd);
        view->view.camera = api::camera_of(*camera);
    });
}

clq_status clq_view_set_height(clq_view *view, float height_px)
{
    return api::boundary("clq_view_set_height", [&] {
        api::require(view != nullptr, "view is NULL");
        if (!(height_px >= 0) || !std::isfinite(height_px))
            base::fail(CLQ_ARGUMENT, "a height of %g pixels: 0 or more is wanted", static_cast<double>(height_px));
        const api::Busy busy(view->crowd);
        view->view.height_px = height_px;
    });
}

clq_status clq_view_set_cull_scale(clq_view *view, float scale)
{
    return api::boundary("clq_view_set_cull_scale", [&] {
        api::require(view != nullptr, "view is NULL");
        if (!(scale > 0 && scale <= 1))
            base::fail(CLQ_ARGUMENT, "a culling pyramid of %g times the picture's: more than 0, at most 1 is wanted",
                       static_cast<double>(scale));
        const api::Busy busy(view->crowd);
        view->view.cull_scale = scale;
    });
}

clq_status clq_view_set_tile(clq_view *view, const float tile[4])
{
    return api::boundary("clq_view_set_tile", [&] {
        api::require(view && tile, "view or tile is NULL");
        const auto reaches = [&](int low, int high) {
            return tile[low] >= 0 && tile[low] < tile[high] && tile[high] <= 1;
        };
        if (!reaches(0, 2) || !reaches(1, 3))
            base::fail(CLQ_ARGUMENT,
                       "a tile from (%g, %g) to (%g, %g): shares of the picture from 0 to 1 are wanted, the second "
                       "corner right of and above the first",
                       double(tile[0]), double(tile[1]), double(tile[2]), double(tile[3]));
        const api::Busy busy(view->crowd);
        std::copy(tile, tile + 4, view->view.tile);
    });
}

clq_status clq_view_set_shadow(clq_view *view, const float fall[3])
{
    return api::boundary("clq_view_set_shadow", [&] {
        api::require(view && fall, "view or fall is NULL");
        api::require(std::isfinite(fall[0]) && std::isfinite(fall[1]) && std::isfinite(fall[2]),
                     "the vector by which shadows fall is not finite");
        const api::Busy busy(view->crowd);
        view->view.shadow = glm::vec3(fall[0], fall[1], fall[2]);
    });
}

clq_status clq_view_get_stats(const clq_view *view, clq_view_stats *out)
{
    return api::boundary("clq_view_get_stats", [&] {
        api::require(view && out, "view or out is NULL");
        api::require_size(*out, "clq_view_stats_init");
        const api::Drawing drawing(view);
        clq_view_stats stats = clq_view_stats_init();
        stats.visible = static_cast<uint32_t>(view->view.list.items.size());
        stats.bytes = view->view.bytes();
        stats.triangles = static_cast<uint32_t>(frame::triangle_count(view->view.list));
        for (const draw::Item &item : view->view.list.items) {
            stats.shadow_only += item.shadow_only;
            if (item.shadow_only) continue;
            const size_t parts = item.tmpl->levels[item.level].parts.size();
            for (size_t k = 0; k < parts; ++k) ++(item.parts >> k & 1 ? stats.parts : stats.parts_left_out);
        }
        api::write_out(out, stats);
    });
}

uint64_t clq_view_get_hash(const clq_view *view)
{
    uint64_t hash = 0;
    if (!view) return hash;
    api::boundary("clq_view_get_hash", [&] {
        const api::Drawing drawing(view);
        hash = frame::hash(view->view.list);
    });
    return hash;
}

clq_status clq_crowd_get_view_changes(const clq_crowd *crowd, clq_view_change *out, size_t capacity, size_t *out_count)
{
    return api::boundary("clq_crowd_get_view_changes", [&] {
        api::require(crowd && out_count && (out || capacity == 0), "crowd, out or out_count is NULL");
        const api::Reading reading(crowd);
        const frame::ViewChanges &changes = crowd->frame.view_changes();
        size_t count = 0;
        changes.for_each(crowd->crowd, [&](uint32_t, bool) { ++count; });
        if (out && count > capacity)
            base::fail(CLQ_LIMIT, "%zu actors entered or left view: there is room for %zu", count, capacity);
        if (out)
            changes.for_each(crowd->crowd, [&](uint32_t row, bool in_view) {
                const crowd::Id id = crowd->crowd.id_of(row);
                *out++ = {{id.index1, id.generation}, in_view};
            });
        *out_count = count;
    });
}

}  // extern "C"
