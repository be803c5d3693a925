// clq_scene_...: scenes, what they take over, and what a host gives individuals.
#include <algorithm>
#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/scene_handle.h"

using namespace claque;

namespace claque::api
{

void reserve_scenes(clq_crowd *crowd, clq_view *const *views, uint32_t view_count)
{
    for (clq_scene *scene : crowd->scenes) {
        scene->scene.reserve(crowd->crowd);
        for (uint32_t i = 0; i < view_count; ++i) scene->scene.reserve_view(crowd->crowd, views[i]);
    }
}

void update_scenes(clq_crowd *crowd, clq_view *const *views, uint32_t view_count, double time_s) noexcept
{
    for (clq_scene *scene : crowd->scenes) {
        scene->scene.take_over(crowd->crowd, time_s);
        for (uint32_t i = 0; i < view_count; ++i) scene->scene.show(crowd->crowd, views[i], views[i]->view.list);
        scene->scene.set_drawn(true);
    }
}

}  // namespace claque::api

namespace
{

void stop_reading(clq_crowd *crowd, const crowd::Changes *changes)
{
    auto &readers = crowd->crowd.readers;
    readers.erase(std::remove(readers.begin(), readers.end(), changes), readers.end());
}

}  // namespace

extern "C" {

clq_status clq_scene_create(clq_crowd *crowd, clq_scene **out)
{
    return api::boundary("clq_scene_create", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        const api::Busy busy(crowd);
        crowd->scenes.reserve(crowd->scenes.size() + 1);
        crowd->crowd.readers.reserve(crowd->crowd.readers.size() + 1);
        base::HostMemory &memory = crowd->context->memory;
        void *place = memory.allocate(sizeof(clq_scene), alignof(clq_scene));
        clq_scene *made = nullptr;
        try {
            made = new (place) clq_scene(crowd);
            made->scene.reserve(crowd->crowd);
        } catch (...) {
            if (made) made->~clq_scene();
            memory.deallocate(place, sizeof(clq_scene), alignof(clq_scene));
            throw;
        }
        made->scene.take_over(crowd->crowd, crowd->frame.last_time_s());
        crowd->scenes.push_back(made);
        crowd->crowd.readers.push_back(&made->scene.changes());
        *out = made;
    });
}

clq_status clq_scene_destroy(clq_scene *scene)
{
    return api::boundary("clq_scene_destroy", [&] {
        if (!scene) return;
        clq_crowd *crowd = scene->crowd;
        const api::Busy busy(crowd);
        stop_reading(crowd, &scene->scene.changes());
        crowd->scenes.erase(std::remove(crowd->scenes.begin(), crowd->scenes.end(), scene), crowd->scenes.end());
        scene->~clq_scene();
        crowd->context->memory.deallocate(scene, sizeof(clq_scene), alignof(clq_scene));
    });
}

clq_status clq_scene_update(clq_scene *scene, double time_s)
{
    return api::boundary("clq_scene_update", [&] {
        api::require(scene != nullptr, "scene is NULL");
        api::require(std::isfinite(time_s), "the time of an update is not finite");
        const api::Busy busy(scene->crowd);
        scene->scene.reserve(scene->crowd->crowd);
        scene->scene.take_over(scene->crowd->crowd, time_s);
    });
}

clq_status clq_scene_set_categories(clq_scene *scene, const clq_actor *actors, uint32_t count, uint64_t categories)
{
    return api::boundary("clq_scene_set_categories", [&] {
        api::require(scene != nullptr, "scene is NULL");
        api::require_array(actors, count, "actors");
        const api::Busy busy(scene->crowd);
        scene->scene.set_categories(scene->crowd->crowd, api::ids_of(scene->crowd, actors, count), count, categories);
    });
}

clq_status clq_scene_set_keys(clq_scene *scene, const clq_actor *actors, const double *keys, uint32_t count)
{
    return api::boundary("clq_scene_set_keys", [&] {
        api::require(scene != nullptr, "scene is NULL");
        api::require_array(actors, count, "actors");
        api::require_array(keys, count, "keys");
        const api::Busy busy(scene->crowd);
        scene->scene.set_keys(scene->crowd->crowd, api::ids_of(scene->crowd, actors, count), keys, count);
    });
}

clq_status clq_scene_get_stats(const clq_scene *scene, clq_scene_stats *out)
{
    return api::boundary("clq_scene_get_stats", [&] {
        api::require(scene && out, "scene or out is NULL");
        api::require_size(*out, "clq_scene_stats_init");
        const api::Reading reading(scene->crowd);
        const scene::Scene &asked = scene->scene;
        clq_scene_stats stats = clq_scene_stats_init();
        stats.actor_count = asked.known_count();
        stats.marked = asked.changes().everything ? stats.actor_count : asked.changes().rows.count();
        stats.moving = asked.mover_count();
        stats.keyed = static_cast<uint32_t>(asked.order().size());
        stats.height = asked.tree().height();
        stats.placed = asked.placed_count();
        stats.bytes = asked.bytes();
        api::write_out(out, stats);
    });
}

}  // extern "C"
