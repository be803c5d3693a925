#include "tests/faults/calls.h"

#include <set>

#include "tests/api/calls.h"
#include "tests/api/failing_memory.h"
#include "tests/faults/watched_gl.h"

namespace faults
{
namespace
{

using W = World &;

// Calls of tests/api/busy_calls.h that allocate; the others never do.
const std::set<std::string> allocate = {
    "clq_actor_create",         "clq_actor_set_colours",   "clq_actor_randomise_colours",
    "clq_actor_clone",          "clq_actor_attach",        "clq_actor_get_node",
    "clq_actor_follow_ground",  "clq_crowd_add_gait",      "clq_crowd_add_mask",
    "clq_actor_fade_to",        "clq_actor_add_layer",     "clq_actor_set_watched",
    "clq_crowd_get_events",     "clq_crowd_add_mechanism", "clq_actor_gaze",
    "clq_actor_express",        "clq_actor_say",           "clq_crowd_add_root_path",
    "clq_actor_play_root_path", "clq_actor_follow_track",  "clq_crowd_randomise_colours",
    "clq_crowd_release_tracks", "clq_group_create",        "clq_view_create",
    "clq_scene_create",         "clq_scene_update",        "clq_scene_set_categories",
    "clq_scene_set_keys",       "clq_view_get_pixels",     "clq_view_get_flow"};
// Made below, with arguments that reach more.
const std::set<std::string> here = {
    "clq_crowd_restore",          "clq_actor_end_layer",       "clq_actor_set_gait_share",
    "clq_renderer_prepare",       "clq_actor_set_hooks",       "clq_actor_detach",
    "clq_crowd_update",           "clq_crowd_set_transforms",  "clq_crowd_set_speeds",
    "clq_actor_attach_mechanism", "clq_renderer_draw_shadows", "clq_renderer_draw_visibility",
    "clq_actor_fade_to_track",    "clq_actor_leave_track",     "clq_crowd_begin_recording",
    "clq_crowd_end_recording",    "clq_crowd_get_recording"};

void add_busy(std::vector<Call> &all)
{
    for (const busy::Call &one : busy::calls()) {
        if (here.count(one.name)) continue;
        uint32_t traits = allocate.count(one.name) ? 0u : uint32_t(quiet);
        if (one.use == busy::Use::changes_crowd) traits |= grows | keeps;  // tables keep the room that they have made
        if (one.name.find("destroy") != std::string::npos || one.name == "clq_renderer_abandon") traits |= ends;
        all.push_back({one.name, [&one](W w) { return one.run(w.objects); }, traits});
    }
}

void add_crowds(std::vector<Call> &all)
{
    all.push_back({"clq_crowd_create",
                   [](W w) { return clq_crowd_create(w.test.context, nullptr, w.out<clq_crowd>()); }, 0,
                   [](W w) { clq_crowd_destroy(static_cast<clq_crowd *>(w.made)); }});
    all.push_back({"clq_crowd_restore", [](W w) {
                       return clq_crowd_restore(w.objects.crowd, w.saved_crowd.data(), w.saved_crowd.size(),
                                                w.test.templates, 2);
                   }});
    all.push_back({"clq_actor_set_hooks",
                   [](W w) {
                       const clq_actor_hooks hooks = {[](void *, clq_actor) { return false; }, nullptr, nullptr};
                       return clq_actor_set_hooks(w.objects.crowd, w.objects.actor, &hooks);
                   },
                   grows | keeps});
    all.push_back({"clq_actor_attach_mechanism",
                   [](W w) {
                       const clq_mechanism_attachment idle = {{5}, 0, 0, 0};
                       return clq_actor_attach_mechanism(w.objects.crowd, w.objects.actor, &idle);
                   },
                   grows | keeps});
    all.push_back({"clq_crowd_set_transforms",
                   [](W w) {
                       clq_transform places[24];
                       for (clq_transform &place : places) place = clq_transform_init();
                       return clq_crowd_set_transforms(w.objects.crowd, w.actors.data(), places, 24);
                   },
                   keeps});
    all.push_back({"clq_crowd_set_speeds",
                   [](W w) {
                       float speeds[24];
                       for (float &speed : speeds) speed = 1.5f;
                       return clq_crowd_set_speeds(w.objects.crowd, w.actors.data(), speeds, 24);
                   },
                   keeps});
    all.push_back({"clq_actor_end_layer",
                   [](W w) { return clq_actor_end_layer(w.objects.crowd, w.objects.actor, w.layer, 1, 0); }, quiet});
    all.push_back({"clq_actor_set_gait_share",
                   [](W w) { return clq_actor_set_gait_share(w.objects.crowd, w.objects.actor, 0.5f, 1, 1); }, quiet});
    all.push_back(
        {"clq_actor_detach", [](W w) { return clq_actor_detach(w.objects.crowd, w.objects.attachment); }, quiet});
    const auto update = [](const char *variant, clq_crowd *World::*crowd, clq_view *World::*view) {
        return Call{"clq_crowd_update", [=](W w) { return clq_crowd_update(w.*crowd, 3, &(w.*view), 1); },
                    keeps | counts, nullptr, variant};
    };
    all.push_back(update("without caches", &World::bare, &World::bare_view));
    all.push_back(update("with key-poses", &World::key_posed, &World::key_view));
    all.push_back(update("the first", &World::young, &World::young_view));
    all.push_back({"clq_key_poses_choose", [](W) {
                       const clq_key_pose_bin bins[3] = {{0, 1, 5}, {1, 2, 3}, {3, 3, 9}};
                       bool chosen[4];
                       return clq_key_poses_choose(bins, 3, 2, chosen, 4);
                   }});
    all.push_back({"clq_camera_get_ray",
                   [](W) {
                       clq_camera camera;
                       clq_ray ray;
                       const clq_look_at_def def = clq_look_at_def_init();
                       const clq_status status = clq_camera_look_at(&def, &camera);
                       return status == CLQ_OK ? clq_camera_get_ray(&camera, 0.5f, 0.5f, &ray) : status;
                   },
                   quiet});
    all.push_back({"clq_camera_look_at",
                   [](W) {
                       clq_camera camera;
                       const double eye[3] = {0, 2, 4}, target[3] = {0, 1, -10};
                       const float up[3] = {0, 1, 0};
                       return api_test::look_at(&camera, eye, target, up, 0.9f, 1.3f, 0.1f, 200);
                   },
                   quiet});
}

void add_renderers(std::vector<Call> &all)
{
    const auto create = [](W w) {
        clq_renderer_def def = clq_renderer_def_init();
        def.get_proc_address = watched_gl::find;
        return clq_renderer_create(w.test.context, &def, w.out<clq_renderer>());
    };
    const auto destroy = [](W w) { clq_renderer_destroy(static_cast<clq_renderer *>(w.made)); };
    all.push_back({"clq_renderer_create", create, 0, destroy});
    const auto note = [](W w) { w.found = watched_gl::textures(); };
    all.push_back(
        {"clq_renderer_prepare", [](W w) { return clq_renderer_prepare(w.fresh, w.test.templates[0]); }, keeps, note});
    all.push_back({"clq_renderer_prepare", [](W w) { return clq_renderer_prepare(w.fresh, w.person_template); }, keeps,
                   note, "person"});
    const auto draw = [](const char *variant, clq_view *World::*view) {
        return Call{"clq_renderer_draw", [=](W w) { return clq_renderer_draw(w.objects.renderer, w.*view, nullptr); },
                    quiet, nullptr, variant};
    };
    all.push_back(draw("without caches", &World::bare_view));
    all.push_back(draw("with key-poses", &World::key_view));
    all.push_back({"clq_renderer_draw", [](W w) { return clq_renderer_draw(w.close, w.bare_view, nullptr); }, keeps,
                   note, "with close textures"});
    all.push_back({"clq_renderer_draw_shadows",
                   [](W w) {
                       const clq_shadow_def def = clq_shadow_def_init();
                       return clq_renderer_draw_shadows(w.without_shadows, w.bare_view, &def, nullptr);
                   },
                   keeps, nullptr, "for the first time"});
    all.push_back({"clq_renderer_draw_visibility",
                   [](W w) { return clq_renderer_draw_visibility(w.without_shadows, w.bare_view, nullptr, nullptr); },
                   keeps, nullptr, "for the first time"});
}

void add_colours(std::vector<Call> &all)
{
    all.push_back({"clq_colour_map_create",
                   [](W w) {
                       clq_colour_map_def def = clq_colour_map_def_init();
                       if (clq_colour_map_get_def(w.objects.map, &def) != CLQ_OK) return CLQ_LIMIT;
                       return clq_colour_map_create(w.test.context, &def, w.out<clq_colour_map>());
                   },
                   0, [](W w) { clq_colour_map_destroy(static_cast<clq_colour_map *>(w.made)); }});
    all.push_back({"clq_colour_map_get_def",
                   [](W w) {
                       clq_colour_map_def def = clq_colour_map_def_init();
                       return clq_colour_map_get_def(w.objects.map, &def);
                   },
                   quiet});
    all.push_back({"clq_colour_map_find",
                   [](W w) { return clq_colour_map_find(w.objects.map, "one") == 0 ? CLQ_OK : CLQ_LIMIT; }, quiet});
    all.push_back({"clq_colour_map_find_template",
                   [](W w) { return clq_colour_map_find_template(w.objects.map, "figure") == 0 ? CLQ_OK : CLQ_LIMIT; },
                   quiet});
    all.push_back({"clq_colour_map_sample", [](W w) {
                       float rgb[6];
                       clq_colour_sample_def def = clq_colour_sample_def_init();
                       def.tmpl = w.test.templates[0], def.actor_seed = 3;
                       return clq_colour_map_sample(w.objects.map, &def, rgb, 2);
                   }});
    all.push_back({"clq_colour_map_destroy",
                   [](W w) {
                       clq_colour_map_destroy(w.objects.map);
                       w.objects.map = nullptr;
                       return CLQ_OK;
                   },
                   quiet | ends});
}

void add_contexts(std::vector<Call> &all)
{
    all.push_back({"clq_context_create",
                   [](W w) {
                       clq_context_def def = clq_context_def_init();
                       def.allocator = failing_memory::allocator;
                       return clq_context_create(&def, w.out<clq_context>());
                   },
                   0, [](W w) { clq_context_destroy(static_cast<clq_context *>(w.made)); }});
    all.push_back({"clq_context_destroy", [](W) { return clq_context_destroy(nullptr); }, quiet});
    all.push_back({"clq_context_log",
                   [](W w) {
                       clq_context_log(w.test.context, CLQ_LOG_INFO, "a note");
                       return CLQ_OK;
                   },
                   quiet});
    all.push_back({"clq_context_run",
                   [](W w) {
                       return clq_context_run(
                           w.test.context, 3, [](void *, uint32_t) {}, nullptr);
                   },
                   quiet});
    all.push_back({"clq_version", [](W) { return clq_version() == CLQ_VERSION ? CLQ_OK : CLQ_LIMIT; }, quiet});
    all.push_back({"clq_status_name", [](W) { return *clq_status_name(CLQ_OK) ? CLQ_OK : CLQ_LIMIT; }, quiet});
    all.push_back({"clq_last_error", [](W) { return clq_last_error() ? CLQ_OK : CLQ_LIMIT; }, quiet});
    all.push_back({"clq_report", [](W) { return clq_report(CLQ_OK, "nothing"); }, quiet});
    all.push_back(
        {"clq_floats_enter", [](W) { return clq_floats_enter() && clq_floats_leave() ? CLQ_OK : CLQ_LIMIT; }, quiet});
    all.push_back({"clq_floats_leave", [](W) { return clq_floats_leave() ? CLQ_LIMIT : CLQ_OK; }, quiet});
    all.push_back({"clq_floats_differ", [](W) { return clq_floats_differ() ? CLQ_LIMIT : CLQ_OK; }, quiet});
    all.push_back({"clq_simd_get", [](W) { return clq_simd_get() <= CLQ_SIMD_FMA ? CLQ_OK : CLQ_LIMIT; }, quiet});
    all.push_back({"clq_simd_set", [](W) { return clq_simd_set(clq_simd_get()); }, quiet});
    all.push_back({"clq_dof_write",
                   [](W) {
                       clq_dof_write(nullptr, 0, 0, 0);
                       return CLQ_OK;
                   },
                   quiet});
}

}  // namespace

void add_other_calls(std::vector<Call> &all)
{
    add_busy(all), add_crowds(all), add_renderers(all), add_colours(all), add_contexts(all);
}

const std::vector<Call> &calls()
{
    static const std::vector<Call> all = [] {
        std::vector<Call> made;
        add_template_calls(made), add_asset_calls(made), add_people_calls(made), add_walking_calls(made),
            add_record_calls(made), add_stage_calls(made), add_other_calls(made);
#ifdef CLAQUE_HAS_NAVIGATION
        add_navigation_calls(made);
#endif
        return made;
    }();
    return all;
}

}  // namespace faults
