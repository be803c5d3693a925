#include "tests/api/busy_calls.h"

#include "tests/api/calls.h"
#include "tests/api/stub_gl.h"

namespace busy
{
namespace
{

clq_status status_of(uint64_t number) { return number == 0 ? CLQ_BUSY : CLQ_OK; }

int take(void *, const void *, size_t) { return 0; }

void add_actors(std::vector<Call> &all)
{
    using O = const Objects &;
    const auto change = [&](const char *name, std::function<clq_status(O)> run) {
        all.push_back({name, Use::changes_crowd, std::move(run)});
    };
    change("clq_actor_create", [](O o) {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = o.world->templates[0];
        clq_actor made;
        return clq_actor_create(o.crowd, &def, &made);
    });
    change("clq_actor_destroy", [](O o) { return clq_actor_destroy(o.crowd, o.actor); });
    change("clq_actor_play", [](O o) {
        const clq_play play = clq_play_init();
        return clq_actor_play(o.crowd, o.actor, &play);
    });
    change("clq_crowd_set_transforms", [](O o) {
        const clq_transform transform = clq_transform_init();
        return clq_crowd_set_transforms(o.crowd, &o.actor, &transform, 1);
    });
    change("clq_actor_set_colours", [](O o) {
        const float rgb[6] = {};
        return clq_actor_set_colours(o.crowd, o.actor, rgb, 2);
    });
    change("clq_actor_randomise_colours",
           [](O o) { return clq_actor_randomise_colours(o.crowd, o.actor, nullptr, 0); });
    change("clq_actor_set_texture_set", [](O o) { return clq_actor_set_texture_set(o.crowd, o.actor, 0); });
    change("clq_actor_clone", [](O o) {
        clq_actor made;
        return clq_actor_clone(o.crowd, o.actor, nullptr, 1, &made);
    });
    change("clq_actor_set_priority", [](O o) { return clq_actor_set_priority(o.crowd, o.actor, 0.5f); });
    change("clq_actor_attach", [](O o) {
        const clq_attachment_def def = clq_attachment_def_init();
        return clq_actor_attach(o.crowd, o.actor, &def, nullptr);
    });
    change("clq_actor_detach", [](O o) { return clq_actor_detach(o.crowd, o.attachment); });
    change("clq_actor_get_node", [](O o) {
        double matrix[16];
        return clq_actor_get_node(o.crowd, o.actor, 0, 1, matrix);
    });
    change("clq_actor_set_hooks", [](O o) { return clq_actor_set_hooks(o.crowd, o.actor, nullptr); });
    change("clq_actor_join", [](O o) { return clq_actor_join(o.crowd, o.actor, o.group, nullptr); });
    change("clq_actor_follow_ground", [](O o) { return clq_actor_follow_ground(o.crowd, o.actor, 0, 0); });
}

void add_plays(std::vector<Call> &all)
{
    using O = const Objects &;
    const auto change = [&](const char *name, std::function<clq_status(O)> run) {
        all.push_back({name, Use::changes_crowd, std::move(run)});
    };
    change("clq_crowd_add_gait", [](O o) {
        clq_gait_def def = clq_gait_def_init();
        def.tmpl = o.world->templates[0];
        clq_gait made;
        return clq_crowd_add_gait(o.crowd, &def, &made);
    });
    change("clq_crowd_add_mask", [](O o) {
        clq_mask_def def = clq_mask_def_init();
        const char *tip = "tip";
        def.tmpl = o.world->templates[0], def.node_count = 1, def.nodes = &tip;
        clq_mask made;
        return clq_crowd_add_mask(o.crowd, &def, &made);
    });
    change("clq_actor_fade_to",
           [](O o) { return api_test::fade_to(o.crowd, o.actor, clq_fade_def_init(), 1, 1, CLQ_CURVE_SMOOTH); });
    change("clq_actor_set_gait_share", [](O o) { return clq_actor_set_gait_share(o.crowd, o.actor, 0.5f, 1, 1); });
    change("clq_actor_add_layer", [](O o) {
        clq_layer_def def = clq_layer_def_init();
        def.play.clip = 0;
        return clq_actor_add_layer(o.crowd, o.actor, &def, nullptr);
    });
    change("clq_actor_end_layer", [](O o) { return clq_actor_end_layer(o.crowd, o.actor, {1}, 1, 0); });
    change("clq_actor_set_watched", [](O o) { return clq_actor_set_watched(o.crowd, o.actor, true); });
    change("clq_crowd_get_events", [](O o) {
        size_t count;
        return api_test::get_events(o.crowd, 0, 1, nullptr, 0, &count);
    });
    change("clq_crowd_add_mechanism", [](O o) {
        const clq_mechanism_def def = o.world->mechanism(TestWorld::blink);
        clq_mechanism made;
        return clq_crowd_add_mechanism(o.crowd, &def, &made);
    });
    change("clq_actor_attach_mechanism", [](O o) {
        const clq_mechanism_attachment attachment = {{1}, 0, 0, 0};
        return clq_actor_attach_mechanism(o.crowd, o.actor, &attachment);
    });
    change("clq_actor_detach_mechanism", [](O o) { return clq_actor_detach_mechanism(o.crowd, o.actor, {1}); });
    change("clq_actor_gaze", [](O o) { return clq_actor_gaze(o.crowd, o.actor, {1}, nullptr, 1); });
    change("clq_actor_express", [](O o) { return clq_actor_express(o.crowd, o.actor, {2}, 0, 1); });
    change("clq_actor_say", [](O o) { return clq_actor_say(o.crowd, o.actor, {4}, 1); });
    change("clq_crowd_add_root_path", [](O o) {
        const clq_root_path_def def = o.world->path(true);
        clq_root_path made;
        return clq_crowd_add_root_path(o.crowd, &def, &made);
    });
    change("clq_actor_play_root_path", [](O o) {
        const clq_root_path_play play = {{1}, 1, 0, 0};
        return clq_actor_play_root_path(o.crowd, o.actor, &play);
    });
    change("clq_crowd_add_track", [](O o) { return clq_crowd_add_track(o.crowd, o.world->tracks[0]); });
    change("clq_crowd_release_tracks", [](O o) { return clq_crowd_release_tracks(o.crowd, nullptr); });
    change("clq_actor_follow_track",
           [](O o) { return clq_actor_follow_track(o.crowd, o.actor, o.world->tracks[0], 1); });
    change("clq_actor_fade_to_track", [](O o) { return clq_actor_fade_to_track(o.crowd, o.actor, 1, 1); });
    change("clq_actor_leave_track", [](O o) { return clq_actor_leave_track(o.crowd, o.actor, 1); });
}

void add_crowds(std::vector<Call> &all)
{
    using O = const Objects &;
    const auto change = [&](const char *name, std::function<clq_status(O)> run) {
        all.push_back({name, Use::changes_crowd, std::move(run)});
    };
    change("clq_crowd_destroy", [](O o) { return clq_crowd_destroy(o.crowd); });
    change("clq_crowd_update", [](O o) { return clq_crowd_update(o.crowd, 9, &o.view, 1); });
    change("clq_crowd_reset_bands", [](O o) { return clq_crowd_reset_bands(o.crowd); });
    change("clq_crowd_set_step_clock", [](O o) { return clq_crowd_set_step_clock(o.crowd, nullptr, nullptr); });
    change("clq_crowd_end_recording", [](O o) { return clq_crowd_end_recording(o.crowd, nullptr); });
    change("clq_crowd_begin_recording", [](O o) {
        clq_recording_def def = clq_recording_def_init();
        def.write = take;
        return clq_crowd_begin_recording(o.crowd, &def);
    });
    change("clq_crowd_set_ground", [](O o) { return clq_crowd_set_ground(o.crowd, nullptr, nullptr); });
    change("clq_crowd_save", [](O o) { return clq_crowd_save(o.crowd, take, nullptr); });
    change("clq_crowd_restore", [](O o) { return clq_crowd_restore(o.crowd, "", 0, o.world->templates, 2); });
    change("clq_crowd_randomise_colours",
           [](O o) { return clq_crowd_randomise_colours(o.crowd, o.map, 0, &o.actor, 1); });
    change("clq_group_create", [](O o) {
        clq_group made;
        return clq_group_create(o.crowd, nullptr, &made);
    });
    change("clq_group_destroy", [](O o) { return clq_group_destroy(o.crowd, o.group); });
    change("clq_group_set_transform", [](O o) {
        const clq_transform transform = clq_transform_init();
        return clq_group_set_transform(o.crowd, o.group, &transform);
    });
    change("clq_group_set_speed", [](O o) { return clq_group_set_speed(o.crowd, o.group, 1); });
    change("clq_crowd_set_speeds", [](O o) {
        const float speed = 1;
        return clq_crowd_set_speeds(o.crowd, &o.actor, &speed, 1);
    });
    change("clq_group_set_enabled", [](O o) { return clq_group_set_enabled(o.crowd, o.group, true); });
    change("clq_view_create", [](O o) {
        clq_view *made;
        return clq_view_create(o.crowd, &made);
    });
    change("clq_view_destroy", [](O o) { return clq_view_destroy(o.view); });
    change("clq_view_set_camera", [](O o) {
        clq_camera camera;
        const double eye[3] = {0, 2, 4}, target[3] = {0, 1, -10};
        const float up[3] = {0, 1, 0};
        api_test::look_at(&camera, eye, target, up, 0.9f, 1.3f, 0.1f, 200);
        return clq_view_set_camera(o.view, &camera);
    });
}

void add_readers(std::vector<Call> &all)
{
    using O = const Objects &;
    const auto read = [&](const char *name, std::function<clq_status(O)> run) {
        all.push_back({name, Use::reads_crowd, std::move(run)});
    };
    read("clq_crowd_get_view_changes", [](O o) {
        size_t count = 0;
        return clq_crowd_get_view_changes(o.crowd, nullptr, 0, &count);
    });
    read("clq_actor_get_info", [](O o) {
        clq_actor_info info = clq_actor_info_init();
        return clq_actor_get_info(o.crowd, o.actor, &info);
    });
    read("clq_crowd_get_actor_count", [](O o) { return status_of(clq_crowd_get_actor_count(o.crowd)); });
    read("clq_crowd_get_hash", [](O o) { return status_of(clq_crowd_get_hash(o.crowd)); });
    read("clq_crowd_get_key_pose_stats", [](O o) {
        clq_key_pose_stats stats = clq_key_pose_stats_init();
        return clq_crowd_get_key_pose_stats(o.crowd, &stats);
    });
    read("clq_crowd_get_recording", [](O o) {
        clq_recording_info info = clq_recording_info_init();
        return clq_crowd_get_recording(o.crowd, &info);
    });
    read("clq_crowd_get_stats", [](O o) {
        clq_crowd_stats stats = clq_crowd_stats_init();
        return clq_crowd_get_stats(o.crowd, &stats);
    });
    read("clq_crowd_get_update_times", [](O o) {
        clq_update_times times = clq_update_times_init();
        return clq_crowd_get_update_times(o.crowd, &times);
    });
    read("clq_group_get_info", [](O o) {
        clq_group_info info = clq_group_info_init();
        return clq_group_get_info(o.crowd, o.group, &info);
    });
    read("clq_actor_sample_play", [](O o) {
        clq_random_play_def def = clq_random_play_def_init();
        const uint32_t clip = 0;
        def.clip_count = 1, def.clips = &clip;
        clq_play play;
        return clq_actor_sample_play(o.crowd, o.actor, &def, &play);
    });
    read("clq_actor_get_active_clips", [](O o) {
        clq_active_clip clips[CLQ_ACTIVE_CLIP_MAX];
        uint32_t count;
        return clq_actor_get_active_clips(o.crowd, o.actor, 1, clips, &count);
    });
    read("clq_actor_get_colours", [](O o) {
        float rgb[6];
        return clq_actor_get_colours(o.crowd, o.actor, rgb, 2);
    });
}

std::vector<Call> all_calls()
{
    std::vector<Call> all;
    add_actors(all), add_plays(all), add_crowds(all), add_readers(all), add_view_calls(all), add_view_settings(all),
        add_scene_calls(all);
    return all;
}

}  // namespace

const std::vector<Call> &calls()
{
    static const std::vector<Call> all = all_calls();
    return all;
}

}  // namespace busy
