// Calls for scenes, tracks, records, views and templates refuse each pointer that they need and that is NULL.
#include "tests/api/null_arguments.h"

namespace
{

using null_arguments::none;
using null_arguments::NullArguments;

int take_bytes(void *, const void *, size_t) { return 0; }

TEST_F(NullArguments, ScenesRefuseThem)
{
    clq_scene *made, *scene = objects_.scene;
    const clq_actor actor = objects_.actor;
    const double key = 1, low[3] = {0, 0, 0}, high[3] = {1, 1, 1};
    clq_scene_actor known = clq_scene_actor_init();
    clq_actor found;
    clq_scene_hit hit;
    uint32_t count;
    clq_camera camera = {};
    clq_ray ray = {{0, 0, 0}, {0, 0, -1}, 10};
    clq_scene_pick pick = clq_scene_pick_init();
    clq_scene_stats stats = clq_scene_stats_init();
    NEEDS(clq_scene_create, none, crowd(), &made);
    NEEDS(clq_scene_update, none, scene, 0);
    NEEDS(clq_scene_set_categories, none, scene, &actor, 1, 4);
    NEEDS(clq_scene_set_keys, none, scene, &actor, &key, 1);
    NEEDS(clq_scene_get_actor, none, scene, actor, 0, &known);
    NEEDS(clq_scene_find, {1}, scene, nullptr, &found, 1, &count);
    NEEDS(clq_scene_find_keys, {3}, scene, 0, 1, nullptr, &found, 1, &count);
    NEEDS(clq_scene_find_next, {3}, scene, actor, false, nullptr, &found);
    NEEDS(clq_scene_find_nearest, {4}, scene, 0, low, 1, nullptr, &hit, 1, &count);
    NEEDS(clq_scene_find_within, {4}, scene, 0, low, 1, nullptr, &hit, 1, &count);
    NEEDS(clq_scene_find_in_box, {4}, scene, 0, low, high, nullptr, &hit, 1, &count);
    NEEDS(clq_scene_find_in_frustum, {3}, scene, 0, &camera, nullptr, &hit, 1, &count);
    NEEDS(clq_scene_find_on_ray, {3}, scene, 0, &ray, nullptr, &hit, 1, &count);
    NEEDS(clq_camera_get_ray, none, &camera, 0, 0, &ray);
    NEEDS(clq_scene_pick_triangle, {3}, scene, objects_.view, &ray, nullptr, &pick);
    NEEDS(clq_scene_get_stats, none, scene, &stats);
}

TEST_F(NullArguments, TracksRefuseThem)
{
    clq_locomotion_def legs = clq_locomotion_def_init();
    clq_locomotion *locomotion, *own = world_.locomotion;
    clq_locomotion_info legs_info = clq_locomotion_info_init();
    clq_track_def def = clq_track_def_init();
    const clq_track_def *const defs[1] = {&def};
    clq_found_passing passing;
    size_t count;
    clq_track *made, *track = world_.tracks[0];
    clq_track_info info = clq_track_info_init();
    clq_track_state state;
    clq_track_plant plant;
    const clq_actor actor = objects_.actor;
    NEEDS(clq_locomotion_create, none, world_.context, &legs, &locomotion);
    NEEDS(clq_locomotion_get_info, none, own, &legs_info);
    NEEDS(clq_find_passings, none, world_.context, defs, 1, &passing, 1, &count);
    NEEDS(clq_track_create, none, own, &def, &made);
    NEEDS(clq_track_get_info, none, track, &info);
    NEEDS(clq_track_evaluate, none, track, 0, &state);
    NEEDS(clq_track_get_plants, none, track, 0, 0, 1, &plant, 1, &count);
    NEEDS(clq_track_save, {2}, track, take_bytes, nullptr);
    NEEDS(clq_track_load, none, own, "a", 1, &made);
    NEEDS(clq_actor_follow_track, none, crowd(), actor, track, 0);
    NEEDS(clq_actor_fade_to_track, none, crowd(), actor, 0, 1);
    NEEDS(clq_actor_leave_track, none, crowd(), actor, 0);
    NEEDS(clq_crowd_add_track, none, crowd(), track);
    NEEDS(clq_crowd_release_tracks, {1}, crowd(), nullptr);
}

TEST_F(NullArguments, RecordsRefuseThem)
{
    clq_recording_def def = clq_recording_def_init();
    def.write = take_bytes;
    clq_recording_info recording = clq_recording_info_init();
    clq_record *made;
    clq_record_info info = clq_record_info_init();
    clq_crowd_def crowd_def = clq_crowd_def_init();
    const clq_host_mechanism_def lent = {world_.mechanism(TestWorld::host).host.run, nullptr, false};
    double time_s;
    NEEDS(clq_crowd_begin_recording, none, crowd(), &def);
    NEEDS(clq_crowd_end_recording, {1}, crowd(), nullptr);
    NEEDS(clq_crowd_get_recording, none, crowd(), &recording);
    NEEDS(clq_record_load, none, world_.context, "a", 1, &made);
    NEEDS(clq_record_open, none, world_.context, "a", 1, &made);
    NEEDS(clq_record_get_info, none, record(), &info);
    NEEDS(clq_record_get_crowd_def, none, record(), &crowd_def);
    NEEDS(clq_record_set_templates, none, record(), world_.templates, 2);
    NEEDS(clq_record_lend_mechanism, none, record(), {1}, &lent);
    NEEDS(clq_record_get_time, none, record(), 0, &time_s);
    NEEDS(clq_record_play_step, none, record(), crowd(), 0);
    NEEDS(clq_record_play, none, record(), crowd(), 0);
}

TEST_F(NullArguments, ViewsAndRenderersRefuseThem)
{
    clq_look_at_def look = clq_look_at_def_init();
    clq_camera camera = {};
    clq_view *made, *view = objects_.view;
    const float tile[4] = {0, 0, 1, 1}, fall[3] = {0, -1, 0};
    clq_view_stats stats = clq_view_stats_init();
    uint64_t triangles;
    clq_drawn_actor drawn = clq_drawn_actor_init();
    clq_drawn_arrays arrays = clq_drawn_arrays_init();
    uint8_t rgb[6];
    float numbers[64];
    const clq_pixels pixels = clq_pixels_init();
    const clq_pixel_channels channels = clq_pixel_channels_init();
    const clq_flow_def flow = clq_flow_def_init();
    const clq_renderer_def def = clq_renderer_def_init();
    clq_renderer *renderer;
    clq_prepared_info prepared = clq_prepared_info_init();
    const clq_shadow_def shadow = clq_shadow_def_init();
    NEEDS(clq_camera_look_at, none, &look, &camera);
    NEEDS(clq_view_create, none, crowd(), &made);
    NEEDS(clq_view_set_camera, none, view, &camera);
    NEEDS(clq_view_set_height, none, view, 768);
    NEEDS(clq_view_set_cull_scale, none, view, 1);
    NEEDS(clq_view_set_tile, none, view, tile);
    NEEDS(clq_view_set_shadow, none, view, fall);
    NEEDS(clq_view_get_stats, none, view, &stats);
    NEEDS(clq_view_get_triangle_count, none, view, &triangles);
    NEEDS(clq_view_get_drawn_actor, none, view, 0, &drawn);
    NEEDS(clq_view_get_arrays, none, view, 0, &arrays);
    NEEDS(clq_view_get_colours, none, view, 0, rgb, 2);
    NEEDS(clq_view_get_vertices, (std::set<size_t>{2, 3}), view, 0, numbers, nullptr, 1);
    NEEDS(clq_view_get_palette, none, view, 0, numbers, 1);
    NEEDS(clq_view_get_morph_weights, none, view, 0, numbers, 1);
    NEEDS(clq_view_get_pixels, none, view, &pixels, &channels);
    NEEDS(clq_view_get_flow, none, view, &pixels, &flow, numbers);
    NEEDS(clq_renderer_create, none, world_.context, &def, &renderer);
    NEEDS(clq_renderer_prepare, none, objects_.renderer, world_.templates[0]);
    NEEDS(clq_renderer_get_prepared, none, objects_.renderer, world_.templates[0], &prepared);
    NEEDS(clq_renderer_draw, {2}, objects_.renderer, view, nullptr);
    NEEDS(clq_renderer_draw_shadows, {3}, objects_.renderer, view, &shadow, nullptr);
    NEEDS(clq_renderer_draw_visibility, (std::set<size_t>{2, 3}), objects_.renderer, view, nullptr, nullptr);
}

TEST_F(NullArguments, TemplatesRefuseThem)
{
    clq_template *made, *tmpl = world_.templates[0];
    clq_template_info info = clq_template_info_init();
    clq_clip_info clip = clq_clip_info_init();
    clq_marker_info marker = clq_marker_info_init();
    clq_zone_info zone = clq_zone_info_init();
    clq_dof_info dof = clq_dof_info_init();
    clq_level_info level = clq_level_info_init();
    clq_texels texels = clq_texels_init();
    clq_picture picture = clq_picture_init();
    clq_mesh mesh = clq_mesh_init();
    clq_triangles triangles = clq_triangles_init();
    clq_morph_target target = clq_morph_target_init();
    const clq_influences influences = clq_influences_init();
    clq_wrap s, t;
    double motion[3];
    NEEDS(clq_template_build, none, world_.context, &world_.plain.def, &made);
    NEEDS(clq_template_save, {2}, tmpl, take_bytes, nullptr);
    NEEDS(clq_template_load, none, world_.context, "a", 1, &made);
    NEEDS(clq_template_get_info, none, tmpl, &info);
    NEEDS(clq_template_get_clip, none, tmpl, 0, &clip);
    NEEDS(clq_template_get_marker, none, tmpl, 0, &marker);
    NEEDS(clq_template_get_zone, none, tmpl, 0, &zone);
    NEEDS(clq_template_get_dof, none, tmpl, 0, &dof);
    NEEDS(clq_template_get_level, none, tmpl, 0, &level);
    NEEDS(clq_template_get_texture, none, tmpl, 0, 0, &texels);
    NEEDS(clq_template_get_split_picture, none, tmpl, 0, 1, &picture);
    NEEDS(clq_template_get_mesh, none, tmpl, 0, &mesh);
    NEEDS(clq_template_get_triangles, none, tmpl, 0, 0, &triangles);
    NEEDS(clq_template_get_morph_target, none, tmpl, 0, 0, &target);
    NEEDS(clq_template_get_influences, none, tmpl, 0, &influences);
    NEEDS(clq_template_get_wrap, none, tmpl, 0, &s, &t);
    NEEDS(clq_template_get_root_motion, none, tmpl, 0, 0, 1, motion);
    EXPECT_EQ(clq_template_find_zone(nullptr, "a"), CLQ_NONE);
    EXPECT_EQ(clq_template_find_zone(tmpl, nullptr), CLQ_NONE);
    EXPECT_EQ(clq_template_find_node(nullptr, "a"), CLQ_NONE);
    EXPECT_EQ(clq_template_find_node(tmpl, nullptr), CLQ_NONE);
    EXPECT_EQ(clq_template_find_dof(nullptr, "a"), CLQ_NONE);
    EXPECT_EQ(clq_template_find_dof(tmpl, nullptr), CLQ_NONE);
    EXPECT_EQ(clq_template_find_clip(tmpl, nullptr), CLQ_NONE);
    EXPECT_EQ(clq_template_find_texture_set(nullptr, "a"), CLQ_NONE);
    EXPECT_EQ(clq_template_find_texture_set(tmpl, nullptr), CLQ_NONE);
    EXPECT_STREQ(clq_template_get_node_name(nullptr, 0), "");
    EXPECT_STREQ(clq_template_get_texture_set_name(nullptr, 0), "");
}

TEST_F(NullArguments, ContextsMapsAndKeyPosesRefuseThem)
{
    clq_context *made;
    clq_colour_map_def def = clq_colour_map_def_init();
    clq_colour_map *map;
    clq_colour_sample_def sample = clq_colour_sample_def_init();
    sample.tmpl = world_.templates[0];
    float rgb[6];
    const clq_key_pose_bin bin = {};
    bool chosen;
    NEEDS(clq_context_create, {0}, nullptr, &made);
    NEEDS(clq_colour_map_create, none, world_.context, &def, &map);
    NEEDS(clq_colour_map_get_def, none, objects_.map, &def);
    NEEDS(clq_colour_map_sample, none, objects_.map, &sample, rgb, 2);
    NEEDS(clq_key_poses_choose, none, &bin, 1, 1, &chosen, 1);
    EXPECT_EQ(clq_colour_map_find(nullptr, "a"), CLQ_NONE);
    EXPECT_EQ(clq_colour_map_find(objects_.map, nullptr), CLQ_NONE);
    EXPECT_EQ(clq_colour_map_find_template(nullptr, "a"), CLQ_NONE);
    EXPECT_EQ(clq_colour_map_find_template(objects_.map, nullptr), CLQ_NONE);
    EXPECT_EQ(clq_context_run(world_.context, 3, nullptr, nullptr), CLQ_OK) << "no job is no work";
    EXPECT_EQ(clq_crowd_get_actor_count(nullptr), 0u);
}

}  // namespace
