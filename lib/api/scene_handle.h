// The struct behind clq_scene, and what the calls for scenes have in common.
#pragma once

#include <claque/scene.h>

#include "lib/api/crowd_handle.h"
#include "lib/scene/questions.h"

struct clq_scene {
    explicit clq_scene(clq_crowd *owner)
        : crowd(owner), scene(&owner->context->memory, 1.0 / double(owner->frame.settings().caches.metres_per_unit))
    {
    }
    clq_crowd *crowd;
    claque::scene::Scene scene;
};

namespace claque::api
{

scene::Filter filter_of(const clq_scene_filter *filter);  // NULL: all; throws base::Error
scene::Ray ray_of(const clq_ray *ray);

// What an update does with all scenes of a crowd. The first may throw, the second cannot fail.
void reserve_scenes(clq_crowd *crowd, clq_view *const *views, uint32_t view_count);
void update_scenes(clq_crowd *crowd, clq_view *const *views, uint32_t view_count, double time_s) noexcept;

}  // namespace claque::api
