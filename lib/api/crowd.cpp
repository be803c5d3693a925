// clq_crowd_...: settings, updates and statistics.
#include <claque/crowd_stats.h>

#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/key_poses.h"
#include "lib/api/recorder.h"
#include "lib/api/scene_handle.h"
#include "lib/api/track_handle.h"

using namespace claque;

namespace
{

void require_budget(const clq_crowd_def &def)
{
    using api::require;
    require(api::number_of(def.clock) <= CLQ_CLOCK_LIVE, "clock is neither CLQ_CLOCK_REFERENCE nor CLQ_CLOCK_LIVE");
    if (!(def.update_budget_ms >= 0) || !std::isfinite(def.update_budget_ms))
        base::fail(CLQ_ARGUMENT, "update_budget_ms is %g: 0 or more is wanted",
                   static_cast<double>(def.update_budget_ms));
    require(def.update_budget_ms == 0 || def.now_s, "update_budget_ms needs now_s, which is NULL");
    if (def.update_budget == 0 && def.update_budget_ms == 0) return;
    require(def.clock == CLQ_CLOCK_LIVE,
            "an update budget lets actors wait, which CLQ_CLOCK_REFERENCE rules out: CLQ_CLOCK_LIVE is wanted");
    require(def.cache != CLQ_CACHE_NONE && def.cull != CLQ_CULL_TRADITIONAL,
            "an update budget needs poses that are kept: CLQ_CACHE_NONE and CLQ_CULL_TRADITIONAL keep none");
}

frame::Settings settings_of(const clq_context &context, const clq_crowd_def &def)
{
    using api::require;
    require(api::number_of(def.cache) <= CLQ_CACHE_NONE,
            "cache is none of CLQ_CACHE_FULL, CLQ_CACHE_ANIMATION, CLQ_CACHE_NONE");
    if (!(def.period_near_s >= 0 && def.period_near_s <= 1))
        base::fail(CLQ_ARGUMENT, "period_near_s is %g: 0 to 1 is wanted", static_cast<double>(def.period_near_s));
    if (!(def.period_far_s >= def.period_near_s) || !std::isfinite(def.period_far_s))
        base::fail(CLQ_ARGUMENT, "period_far_s is %g: at least period_near_s (%g) is wanted",
                   static_cast<double>(def.period_far_s), static_cast<double>(def.period_near_s));
    if (!(def.distance_near_m >= 0) || !(def.distance_far_m > def.distance_near_m) ||
        !std::isfinite(def.distance_far_m))
        base::fail(CLQ_ARGUMENT, "distance_near_m is %g and distance_far_m %g: 0 <= near < far is wanted",
                   static_cast<double>(def.distance_near_m), static_cast<double>(def.distance_far_m));
    if (!(def.metres_per_unit > 0) || !std::isfinite(def.metres_per_unit))
        base::fail(CLQ_ARGUMENT, "metres_per_unit is %g: more than 0 is wanted",
                   static_cast<double>(def.metres_per_unit));
    require(api::number_of(def.cull) <= CLQ_CULL_TRADITIONAL,
            "cull is neither CLQ_CULL_ACTOR nor CLQ_CULL_TRADITIONAL");
    require(api::number_of(def.rigid_mode) <= CLQ_RIGID_MATRICES,
            "rigid_mode is neither CLQ_RIGID_VERTICES nor CLQ_RIGID_MATRICES");
    if (!(def.lod_scale >= 0) || !std::isfinite(def.lod_scale))
        base::fail(CLQ_ARGUMENT, "lod_scale is %g: 0 or more is wanted", static_cast<double>(def.lod_scale));
    if (!(def.lod_hysteresis >= 0 && def.lod_hysteresis < 1))
        base::fail(CLQ_ARGUMENT, "lod_hysteresis is %g: 0 to less than 1 is wanted",
                   static_cast<double>(def.lod_hysteresis));
    if (!(def.motion_tolerance_px >= 0) || !std::isfinite(def.motion_tolerance_px))
        base::fail(CLQ_ARGUMENT, "motion_tolerance_px is %g: 0 or more is wanted",
                   static_cast<double>(def.motion_tolerance_px));
    require(api::number_of(def.vertex_format) <= CLQ_VERTEX_PACKED,
            "vertex_format is neither CLQ_VERTEX_FLOAT nor CLQ_VERTEX_PACKED");
    require_budget(def);
    frame::Settings settings;
    settings.caches.vertex_format = static_cast<animcache::VertexFormat>(def.vertex_format);
    settings.caches.can_defer = def.update_budget > 0 || def.update_budget_ms > 0;
    settings.update_budget = def.update_budget;
    settings.update_budget_ms = def.update_budget_ms;
    settings.now = {def.now_s, def.now_user, context.log};
    settings.clock = static_cast<frame::Clock>(def.clock);
    settings.caches.mode = static_cast<animcache::Mode>(def.cache);
    settings.caches.key_poses = api::settings_of(def.key_poses, def.metres_per_unit);
    if (def.cache_budget_bytes) settings.caches.budget_bytes = def.cache_budget_bytes;
    settings.caches.period = {def.period_near_s, def.period_far_s, def.distance_near_m / def.metres_per_unit,
                              def.distance_far_m / def.metres_per_unit};
    settings.caches.metres_per_unit = def.metres_per_unit;
    settings.cull = static_cast<frame::Cull>(def.cull);
    settings.rigid_mode = static_cast<animcache::RigidMode>(def.rigid_mode);
    settings.motion_tolerance_px = def.motion_tolerance_px;
    settings.lod_scale = def.lod_scale;
    settings.lod_hysteresis = def.lod_hysteresis;
    return settings;
}

}  // namespace

clq_crowd::~clq_crowd()
{
    for (clq_view *view : views) {
        view->~clq_view();
        context->memory.deallocate(view, sizeof(clq_view), alignof(clq_view));
    }
    for (clq_scene *scene : scenes) {
        scene->~clq_scene();
        context->memory.deallocate(scene, sizeof(clq_scene), alignof(clq_scene));
    }
}

extern "C" {

clq_status clq_crowd_create(clq_context *context, const clq_crowd_def *def, clq_crowd **out)
{
    return api::boundary("clq_crowd_create", [&] {
        api::require(context && out, "context or out is NULL");
        const clq_crowd_def wanted = api::read_def(def, clq_crowd_def_init, "clq_crowd_def_init");
        clq_crowd *made = api::make<clq_crowd>(context, context, settings_of(*context, wanted), wanted.seed);
        made->def = wanted;
        *out = made;
    });
}

clq_status clq_crowd_destroy(clq_crowd *crowd)
{
    return api::boundary("clq_crowd_destroy", [&] {
        if (!crowd) return;
        api::lock(crowd);
        api::end_recording(crowd);
        // Templates are released last: the crowd's columns point at them.
        std::pmr::vector<clq_template *> held(std::move(crowd->held));
        const std::pmr::unordered_set<clq_track *> tracks(std::move(crowd->tracks));
        api::unmake(crowd->context, crowd);
        for (clq_track *track : tracks) api::release(track);
        for (clq_template *tmpl : held) api::release(tmpl);
    });
}

clq_status clq_crowd_set_transforms(clq_crowd *crowd, const clq_actor *actors, const clq_transform *transforms,
                                    uint32_t count)
{
    return api::boundary("clq_crowd_set_transforms", [&] {
        api::require(crowd && ((actors && transforms) || count == 0), "crowd, actors or transforms is NULL");
        const api::Busy busy(crowd);
        crowd->placed.clear();
        crowd->placed.reserve(count);
        for (uint32_t i = 0; i < count; ++i) crowd->placed.push_back(api::transform_of(transforms[i]));
        crowd::set_transforms(crowd->crowd, api::ids_of(crowd, actors, count), crowd->placed.data(), count);
        api::changed_by(crowd, [&](api::Recorder &to) { to.transforms(actors, transforms, count); });
    });
}

uint32_t clq_crowd_get_actor_count(const clq_crowd *crowd)
{
    uint32_t count = 0;
    if (!crowd) return count;
    api::boundary("clq_crowd_get_actor_count", [&] {
        const api::Reading reading(crowd);
        count = crowd->crowd.actor_count();
    });
    return count;
}

clq_status clq_crowd_update(clq_crowd *crowd, double time_s, clq_view *const *views, uint32_t view_count)
{
    return api::boundary("clq_crowd_update", [&] {
        api::require(crowd && (views || view_count == 0), "crowd or views is NULL");
        const api::Busy busy(crowd);
        crowd->views_of_update.clear();
        for (uint32_t i = 0; i < view_count; ++i) {
            api::require(views[i] != nullptr, "a view is NULL");
            if (views[i]->crowd != crowd) base::fail(CLQ_ARGUMENT, "view %u belongs to another crowd", i);
            for (uint32_t k = 0; k < i; ++k)
                if (views[k] == views[i]) base::fail(CLQ_ARGUMENT, "views %u and %u are the same", k, i);
            crowd->views_of_update.push_back(&views[i]->view);
        }
        api::reserve_scenes(crowd, views, view_count);
        api::require(frame::update(crowd->crowd, crowd->frame,
                                   base::Span<frame::View *const>(crowd->views_of_update.data(), view_count), time_s,
                                   crowd->context->jobs));
        for (clq_view *view : crowd->views) {
            bool asked = false;
            for (uint32_t i = 0; i < view_count; ++i) asked = asked || views[i] == view;
            if (!asked) view->view.list.items.clear();
        }
        api::update_scenes(crowd, views, view_count, time_s);
        if (crowd->recorder) crowd->recorder->step(time_s);
    });
}

clq_status clq_crowd_get_stats(const clq_crowd *crowd, clq_crowd_stats *out)
{
    return api::boundary("clq_crowd_get_stats", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        api::require_size(*out, "clq_crowd_stats_init");
        const api::Reading reading(crowd);
        const frame::Stats &stats = crowd->frame.stats();
        clq_crowd_stats result = clq_crowd_stats_init();
        result.actor_count = crowd->crowd.actor_count();
        result.groups = stats.groups;
        result.groups_visible = stats.groups_visible;
        result.tested = stats.tested;
        result.passed_refpoint = stats.passed_refpoint;
        result.passed_sklsroot = stats.passed_sklsroot;
        result.crossing = stats.crossing;
        result.sphere_tests = stats.sphere_tests;
        result.spheres_built = stats.spheres_built;
        result.roots_placed = stats.roots_placed;
        result.distances = stats.distances;
        result.matrices_needed = stats.matrices_needed;
        result.matrices_built = stats.matrices_built;
        result.products = stats.products;
        result.products_tracked = stats.products_tracked;
        for (int k = 0; k < 6; ++k) result.behaviour_calls[k] = stats.behaviour.calls[k];
        result.dof_writes = stats.behaviour.writes;
        result.visible = stats.visible;
        result.due = stats.due;
        result.animated = stats.animated;
        result.skinned = stats.skinned;
        result.palette_served = stats.palette_served;
        result.vertices_served = stats.vertices_served;
        result.on_demand = stats.on_demand;
        result.deferred = stats.deferred;
        result.overdue = stats.overdue;
        result.over_budget = stats.over_budget;
        result.evicted = stats.evicted;
        result.cache_bytes = stats.cache_bytes;
        result.cache_pool_bytes = stats.cache_pool_bytes;
        result.cache_budget_bytes = stats.cache_budget_bytes;
        result.actor_bytes = crowd->crowd.bytes();
        static_assert(CLQ_DISTANCE_BAND_COUNT == frame::band_count, "the C API shows every band");
        const float metres = crowd->frame.settings().caches.metres_per_unit;
        for (uint32_t i = 0; i < CLQ_DISTANCE_BAND_COUNT; ++i) {
            const frame::Band &band = stats.bands[i];
            result.bands[i] = {band.distance_min * metres, band.distance_max * metres, band.actor_frames, band.seconds,
                               band.animated};
        }
        result.frame_bytes = stats.frame_bytes;
        result.arena_bytes = stats.arena_bytes;
        result.left_out = stats.left_out;
        api::write_out(out, result);
    });
}

clq_status clq_crowd_reset_bands(clq_crowd *crowd)
{
    return api::boundary("clq_crowd_reset_bands", [&] {
        api::require(crowd != nullptr, "crowd is NULL");
        const api::Busy busy(crowd);
        crowd->frame.reset_bands();
    });
}

uint64_t clq_crowd_get_hash(const clq_crowd *crowd)
{
    uint64_t hash = 0;
    if (!crowd) return hash;
    api::boundary("clq_crowd_get_hash", [&] {
        const api::Reading reading(crowd);
        hash = crowd->crowd.hash();
    });
    return hash;
}

}  // extern "C"
