// clq_scene_pick_triangle, and rays through pictures.
#include <cmath>

#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "lib/api/boundary.h"
#include "lib/api/camera_def.h"
#include "lib/api/inspected.h"
#include "lib/api/scene_handle.h"
#include "lib/math/eye_transform.h"
#include "lib/scene/pick.h"

using namespace claque;

namespace
{

clq_scene_pick pick_of(const clq_view *view, const scene::Pick &found, const scene::Ray &ray)
{
    clq_scene_pick out = clq_scene_pick_init();
    if (found.item == model::none) return out;
    const draw::Item &item = view->view.list.items[found.item];
    out.actor = {item.actor_index + 1, item.generation};
    out.index = found.item, out.part = found.part, out.zone = found.zone;
    for (int k = 0; k < 3; ++k) {
        out.vertices[k] = found.vertices[k];
        out.barycentric[k] = static_cast<float>(found.barycentric[k]);
        out.position[k] = ray.origin[k] + ray.direction[k] * found.distance;
    }
    out.distance = found.distance;
    return out;
}

}  // namespace

extern "C" {

clq_status clq_scene_pick_triangle(const clq_scene *scene, const clq_view *view, const clq_ray *ray,
                                   const clq_scene_filter *filter, clq_scene_pick *out)
{
    return api::boundary("clq_scene_pick_triangle", [&] {
        api::require(scene && view && ray && out, "scene, view, ray or out is NULL");
        api::require_size(*out, "clq_scene_pick_init");
        api::require(view->crowd == scene->crowd, "the view is of another crowd than the scene");
        const scene::Filter wanted = api::filter_of(filter);
        const scene::Ray along = api::ray_of(ray);
        const api::Drawing drawing(view);
        api::InspectedSource skinned(view);
        const scene::Asked asked = {scene->scene, scene->crowd->crowd, wanted, scene->scene.time_s()};
        api::write_out(out, pick_of(view, scene::pick(asked, {view->view.list, view, skinned}, along), along));
    });
}

clq_status clq_camera_get_ray(const clq_camera *camera, float x, float y, clq_ray *out)
{
    return api::boundary("clq_camera_get_ray", [&] {
        api::require(camera && out, "camera or out is NULL");
        const frame::Camera seen = api::camera_of(*camera);
        if (!(std::fabs(x) <= 1 && std::fabs(y) <= 1))
            base::fail(CLQ_ARGUMENT, "the point (%g, %g) is not in the picture, which goes from -1 to 1", double(x),
                       double(y));
        glm::dmat4 projection;
        for (int k = 0; k < 16; ++k) projection[k / 4][k % 4] = double(seen.projection[k]);
        const glm::dmat4 back = glm::inverse(projection);
        // A point on the near plane, and one half way in depth, which is finite even where the far plane is not.
        const glm::dvec4 near = back * glm::dvec4(x, y, -1, 1), far = back * glm::dvec4(x, y, 0, 1);
        const glm::dvec3 from = glm::dvec3(near) / near.w, step = glm::dvec3(far) / far.w - from;
        const glm::dmat3 eye_to_world = glm::transpose(math::rotation_of(seen.rotation));
        const glm::dvec3 origin = seen.eye + eye_to_world * from, direction = eye_to_world * step;
        const double length = std::sqrt(step.x * step.x + step.y * step.y + step.z * step.z);
        api::require(length > 0 && std::isfinite(length) && std::isfinite(origin.x + origin.y + origin.z),
                     "the camera's projection has no inverse");
        for (int k = 0; k < 3; ++k) out->origin[k] = origin[k], out->direction[k] = direction[k] / length;
        out->max_distance = HUGE_VAL;
    });
}

}  // extern "C"
