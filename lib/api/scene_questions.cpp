// clq_scene_find...: questions to a scene.
#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/camera_def.h"
#include "lib/api/scene_handle.h"
#include "lib/math/eye_transform.h"

using namespace claque;

namespace claque::api
{

scene::Filter filter_of(const clq_scene_filter *filter)
{
    const clq_scene_filter wanted = read_def(filter, clq_scene_filter_init, "clq_scene_filter_init");
    return {wanted.tmpl, wanted.texture_set, wanted.level, wanted.any_of, wanted.all_of, wanted.none_of};
}

scene::Ray ray_of(const clq_ray *ray)
{
    scene::Ray out;
    for (int k = 0; k < 3; ++k) {
        if (!std::isfinite(ray->origin[k]) || !std::isfinite(ray->direction[k]))
            base::fail(CLQ_ARGUMENT, "coordinate %d of a ray's origin or direction is not finite", k);
        out.origin[k] = ray->origin[k];
    }
    const glm::dvec3 along(ray->direction[0], ray->direction[1], ray->direction[2]);
    const double most = std::fmax(std::fmax(std::fabs(along.x), std::fabs(along.y)), std::fabs(along.z));
    const double length = most > 0 ? most * glm::length(along / most) : 0;
    if (!(length > 0) || !std::isfinite(length)) base::fail(CLQ_ARGUMENT, "a ray's direction has length %g", length);
    for (int k = 0; k < 3; ++k) out.direction[k] = ray->direction[k] / length;
    if (!(ray->max_distance >= 0))
        base::fail(CLQ_ARGUMENT, "a ray's max_distance is %g: 0 or more is wanted", ray->max_distance);
    out.length = ray->max_distance;
    return out;
}

}  // namespace claque::api

namespace
{

glm::dvec3 point_of(const double point[3])
{
    for (int k = 0; k < 3; ++k)
        if (!std::isfinite(point[k])) base::fail(CLQ_ARGUMENT, "coordinate %d of a point is not finite", k);
    return glm::dvec3(point[0], point[1], point[2]);
}

void require_radius(double radius)
{
    if (!(radius >= 0)) base::fail(CLQ_ARGUMENT, "a distance of %g: 0 or more is wanted", radius);
}

// Checks what all questions have, keeps the crowd as it is, and asks.
template <class Ask>
clq_status ask(const char *function, const clq_scene *scene, const clq_scene_filter *filter, const void *out,
               uint32_t capacity, uint32_t *out_count, const Ask &question)
{
    return api::boundary(function, [&] {
        api::require(scene && out_count, "scene or out_count is NULL");
        api::require_array(out, capacity, "the array of answers");
        const scene::Filter wanted = api::filter_of(filter);
        const api::Reading reading(scene->crowd);
        *out_count = question(scene::Asked{scene->scene, scene->crowd->crowd, wanted});
    });
}

// The same at a time. `prepare` checks the rest and returns the question.
template <class Prepare>
clq_status ask_at(const char *function, const clq_scene *scene, double time_s, bool given,
                  const clq_scene_filter *filter, const scene::Room &room, uint32_t *out_count, const Prepare &prepare)
{
    return ask(function, scene, filter, room.hits, room.capacity, out_count, [&](scene::Asked asked) {
        api::require(given, "what the question is about is NULL");
        api::require(std::isfinite(time_s), "the time of a question is not finite");
        asked.time_s = time_s;
        return prepare(asked);
    });
}

}  // namespace

extern "C" {

clq_status clq_scene_get_actor(const clq_scene *scene, clq_actor actor, double time_s, clq_scene_actor *out)
{
    return api::boundary("clq_scene_get_actor", [&] {
        api::require(scene && out, "scene or out is NULL");
        api::require_size(*out, "clq_scene_actor_init");
        api::require(std::isfinite(time_s), "the time of a question is not finite");
        const api::Reading reading(scene->crowd);
        const crowd::Crowd &crowd = scene->crowd->crowd;
        const uint32_t row = crowd.row_of(api::id_of(actor));
        clq_scene_actor found = clq_scene_actor_init();
        scene::Body body;
        found.present = scene::body_at(crowd, row, time_s, body);
        for (int k = 0; k < 3 && found.present; ++k)
            found.position[k] = body.place[k], found.centre[k] = body.centre[k];
        if (found.present) found.radius = body.radius;
        found.tmpl = static_cast<const clq_template *>(&crowd.template_of(row));
        found.texture_set = crowd.actor(row).texture_set;
        found.level = scene->scene.level_of(crowd, row);
        found.categories = scene->scene.categories_of(crowd, row);
        found.key = scene->scene.key_of(crowd, row);
        api::write_out(out, found);
    });
}

clq_status clq_scene_find(const clq_scene *scene, const clq_scene_filter *filter, clq_actor *out_actors,
                          uint32_t capacity, uint32_t *out_count)
{
    return ask("clq_scene_find", scene, filter, out_actors, capacity, out_count,
               [&](const scene::Asked &asked) { return scene::find(asked, out_actors, capacity); });
}

clq_status clq_scene_find_keys(const clq_scene *scene, double low, double high, const clq_scene_filter *filter,
                               clq_actor *out_actors, uint32_t capacity, uint32_t *out_count)
{
    return ask("clq_scene_find_keys", scene, filter, out_actors, capacity, out_count, [&](const scene::Asked &asked) {
        api::require(!std::isnan(low) && !std::isnan(high), "an end of the range of keys is not a number");
        return scene::find_keys(asked, low, high, out_actors, capacity);
    });
}

clq_status clq_scene_find_next(const clq_scene *scene, clq_actor actor, bool back, const clq_scene_filter *filter,
                               clq_actor *out)
{
    return api::boundary("clq_scene_find_next", [&] {
        api::require(scene && out, "scene or out is NULL");
        const scene::Filter wanted = api::filter_of(filter);
        const api::Reading reading(scene->crowd);
        const crowd::Crowd &crowd = scene->crowd->crowd;
        const uint32_t row = crowd.row_of(api::id_of(actor));
        api::require(!std::isnan(scene->scene.key_of(crowd, row)),
                     "the actor has no key: clq_scene_set_keys gives one");
        uint32_t next = 0;
        if (!scene::next_in_order({scene->scene, crowd, wanted}, row, back, next)) *out = {0, 0};
        else *out = {next + 1, crowd.actor(next).generation};
    });
}

clq_status clq_scene_find_nearest(const clq_scene *scene, double time_s, const double point[3], double max_distance,
                                  const clq_scene_filter *filter, clq_scene_hit *out_hits, uint32_t capacity,
                                  uint32_t *out_count)
{
    const scene::Room room = {out_hits, capacity};
    return ask_at("clq_scene_find_nearest", scene, time_s, point, filter, room, out_count, [&](const auto &asked) {
        require_radius(max_distance);
        return scene::find_nearest(asked, point_of(point), max_distance, room);
    });
}

clq_status clq_scene_find_within(const clq_scene *scene, double time_s, const double point[3], double radius,
                                 const clq_scene_filter *filter, clq_scene_hit *out_hits, uint32_t capacity,
                                 uint32_t *out_count)
{
    const scene::Room room = {out_hits, capacity};
    return ask_at("clq_scene_find_within", scene, time_s, point, filter, room, out_count, [&](const auto &asked) {
        require_radius(radius);
        return scene::find_within(asked, point_of(point), radius, room);
    });
}

clq_status clq_scene_find_in_box(const clq_scene *scene, double time_s, const double low[3], const double high[3],
                                 const clq_scene_filter *filter, clq_scene_hit *out_hits, uint32_t capacity,
                                 uint32_t *out_count)
{
    const scene::Room room = {out_hits, capacity};
    return ask_at("clq_scene_find_in_box", scene, time_s, low && high, filter, room, out_count, [&](const auto &asked) {
        for (int k = 0; k < 3; ++k)
            if (!(low[k] <= high[k]))
                base::fail(CLQ_ARGUMENT, "coordinate %d of a box goes from %g to %g", k, low[k], high[k]);
        return scene::find_in_box(asked, glm::dvec3(low[0], low[1], low[2]), glm::dvec3(high[0], high[1], high[2]),
                                  room);
    });
}

clq_status clq_scene_find_in_frustum(const clq_scene *scene, double time_s, const clq_camera *camera,
                                     const clq_scene_filter *filter, clq_scene_hit *out_hits, uint32_t capacity,
                                     uint32_t *out_count)
{
    const scene::Room room = {out_hits, capacity};
    return ask_at("clq_scene_find_in_frustum", scene, time_s, camera, filter, room, out_count, [&](const auto &asked) {
        const frame::Camera seen = api::camera_of(*camera);
        const math::Frustum frustum =
            math::rotated_back(math::frustum_of(seen.projection), math::rotation_of(seen.rotation));
        return scene::find_in_frustum(asked, seen.eye, frustum, room);
    });
}

clq_status clq_scene_find_on_ray(const clq_scene *scene, double time_s, const clq_ray *ray,
                                 const clq_scene_filter *filter, clq_scene_hit *out_hits, uint32_t capacity,
                                 uint32_t *out_count)
{
    const scene::Room room = {out_hits, capacity};
    return ask_at("clq_scene_find_on_ray", scene, time_s, ray, filter, room, out_count,
                  [&](const auto &asked) { return scene::find_on_ray(asked, api::ray_of(ray), room); });
}

}  // extern "C"
