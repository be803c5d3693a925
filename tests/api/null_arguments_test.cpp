// Each call of libclaque refuses each pointer that it needs and that is NULL, in a sentence, and changes nothing.
#include "tests/api/null_arguments.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/patterns.h"

namespace
{

using null_arguments::none;
using null_arguments::NullArguments;

int take_saved(void *, const void *, size_t) { return 0; }
double flat_ground(void *, const double *) { return 0; }
double no_time(void *) { return 0; }

std::string text_of(const std::filesystem::path &path)
{
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

TEST(NullTable, HoldsEveryCallOfLibclaqueThatTakesAPointer)
{
    const std::set<std::string> of_other_libraries = {
        "agents.h",     "assets.h",  "asset_info.h", "colour_files.h", "levels.h",
        "navigation.h", "prepare.h", "stage.h",      "trajectories.h", "zones.h"};
    // These do nothing for NULL, or need no pointer.
    std::set<std::string> listed = {"clq_crowd_destroy",    "clq_scene_destroy",    "clq_view_destroy",
                                    "clq_renderer_destroy", "clq_renderer_abandon", "clq_context_destroy",
                                    "clq_report",           "clq_simd_set",         "clq_context_run"};
    std::set<std::string> declared;
    for (const auto &header : std::filesystem::directory_iterator(CLAQUE_SOURCE_DIR "/include/claque")) {
        if (of_other_libraries.count(header.path().filename().string())) continue;
        for (const patterns::Match &found :
             patterns::matches(R"(CLQ_API clq_status (clq_\w+)\()", text_of(header.path())))
            declared.insert(found[1]);
    }
    for (const char *file : {"null_arguments_test.cpp", "null_scene_arguments_test.cpp"})
        for (const patterns::Match &found :
             patterns::matches(R"(NEEDS\((clq_\w+))", text_of(std::string(CLAQUE_SOURCE_DIR "/tests/api/") + file)))
            listed.insert(found[1]);
    EXPECT_EQ(declared, listed);
}

TEST_F(NullArguments, CrowdsAndGroupsRefuseThem)
{
    clq_crowd *made;
    clq_crowd_stats stats = clq_crowd_stats_init();
    clq_update_times times = clq_update_times_init();
    clq_key_pose_stats poses = clq_key_pose_stats_init();
    clq_view_change changes[1];
    size_t count;
    const float speed = 1;
    const clq_transform place = clq_transform_init();
    clq_group group;
    clq_group_info info = clq_group_info_init();
    NEEDS(clq_crowd_create, {1}, world_.context, nullptr, &made);
    NEEDS(clq_crowd_set_transforms, none, crowd(), &objects_.actor, &place, 1);
    NEEDS(clq_crowd_update, none, crowd(), 0, &objects_.view, 1);
    NEEDS(clq_crowd_get_stats, none, crowd(), &stats);
    NEEDS(clq_crowd_reset_bands, none, crowd());
    NEEDS(clq_crowd_set_step_clock, (std::set<size_t>{1, 2}), crowd(), no_time, nullptr);
    NEEDS(clq_crowd_get_update_times, none, crowd(), &times);
    NEEDS(clq_crowd_get_key_pose_stats, none, crowd(), &poses);
    NEEDS(clq_crowd_get_view_changes, none, crowd(), changes, 1, &count);
    NEEDS(clq_crowd_set_speeds, none, crowd(), &objects_.actor, &speed, 1);
    NEEDS(clq_crowd_set_ground, (std::set<size_t>{1, 2}), crowd(), flat_ground, nullptr);
    NEEDS(clq_crowd_save, {2}, crowd(), take_saved, nullptr);
    NEEDS(clq_crowd_restore, none, crowd(), "a", 1, world_.templates, 2);
    NEEDS(clq_crowd_randomise_colours, none, crowd(), objects_.map, 0, &objects_.actor, 1);
    NEEDS(clq_group_create, {1}, crowd(), nullptr, &group);
    NEEDS(clq_group_destroy, none, crowd(), objects_.group);
    NEEDS(clq_group_set_transform, none, crowd(), objects_.group, &place);
    NEEDS(clq_group_set_enabled, none, crowd(), objects_.group, true);
    NEEDS(clq_group_set_speed, none, crowd(), objects_.group, 1);
    NEEDS(clq_group_get_info, none, crowd(), objects_.group, &info);
}

TEST_F(NullArguments, ActorsRefuseThem)
{
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = world_.templates[0];
    clq_actor made;
    clq_actor_info info = clq_actor_info_init();
    const clq_attachment_def object = clq_attachment_def_init();
    double matrix[16];
    float rgb[6] = {};
    const clq_hsb_range ranges[2] = {};
    const clq_play play = clq_play_init();
    const clq_actor actor = objects_.actor;
    NEEDS(clq_actor_create, none, crowd(), &def, &made);
    EXPECT_EQ(clq_actor_create(crowd(), nullptr, &made), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("crowd, def or out is NULL"), std::string::npos) << clq_last_error();
    NEEDS(clq_actor_destroy, none, crowd(), actor);
    NEEDS(clq_actor_play, none, crowd(), actor, &play);
    NEEDS(clq_actor_set_colours, none, crowd(), actor, rgb, 2);
    NEEDS(clq_actor_randomise_colours, none, crowd(), actor, ranges, 2);
    NEEDS(clq_actor_get_colours, none, crowd(), actor, rgb, 2);
    NEEDS(clq_actor_set_texture_set, none, crowd(), actor, 0);
    NEEDS(clq_actor_clone, {2}, crowd(), actor, nullptr, 1, &made);
    NEEDS(clq_actor_set_priority, none, crowd(), actor, 0.5f);
    NEEDS(clq_actor_attach, {3}, crowd(), actor, &object, nullptr);
    NEEDS(clq_actor_detach, none, crowd(), objects_.attachment);
    NEEDS(clq_actor_get_node, none, crowd(), actor, 0, 1, matrix);
    NEEDS(clq_actor_set_hooks, {2}, crowd(), actor, nullptr);
    NEEDS(clq_actor_get_info, none, crowd(), actor, &info);
    NEEDS(clq_actor_join, {3}, crowd(), actor, objects_.group, nullptr);
    NEEDS(clq_actor_follow_ground, none, crowd(), actor, 0, 0);
}

TEST_F(NullArguments, WhatActorsPlayRefusesThem)
{
    const clq_actor actor = objects_.actor;
    clq_gait_def gait = clq_gait_def_init();
    clq_mask_def mask = clq_mask_def_init();
    clq_gait made_gait;
    clq_mask made_mask;
    const clq_fade_def fade = clq_fade_def_init();
    const clq_layer_def layer = clq_layer_def_init();
    const clq_random_play_def random = clq_random_play_def_init();
    clq_play play;
    clq_active_clip clips[CLQ_ACTIVE_CLIP_MAX];
    uint32_t count;
    size_t events;
    clq_event event;
    const clq_time_range range = {0, 1};
    const clq_mechanism_def mechanism = world_.mechanism(TestWorld::blink);
    clq_mechanism made_mechanism;
    const clq_mechanism_attachment attachment = {{1}, 0, 0, 0};
    const clq_root_path_def path = world_.path(true);
    clq_root_path made_path;
    const clq_root_path_play path_play = {{1}, 1, 0, 0};
    NEEDS(clq_crowd_add_gait, none, crowd(), &gait, &made_gait);
    NEEDS(clq_crowd_add_mask, none, crowd(), &mask, &made_mask);
    NEEDS(clq_actor_fade_to, none, crowd(), actor, &fade);
    NEEDS(clq_actor_set_gait_share, none, crowd(), actor, 0.5f, 1, 1);
    NEEDS(clq_actor_add_layer, {3}, crowd(), actor, &layer, nullptr);
    NEEDS(clq_actor_end_layer, none, crowd(), actor, {1}, 1, 0);
    NEEDS(clq_actor_sample_play, none, crowd(), actor, &random, &play);
    NEEDS(clq_actor_get_active_clips, none, crowd(), actor, 1, clips, &count);
    NEEDS(clq_actor_set_watched, none, crowd(), actor, true);
    NEEDS(clq_crowd_get_events, none, crowd(), &range, &event, 1, &events);
    NEEDS(clq_crowd_add_mechanism, none, crowd(), &mechanism, &made_mechanism);
    NEEDS(clq_actor_attach_mechanism, none, crowd(), actor, &attachment);
    NEEDS(clq_actor_detach_mechanism, none, crowd(), actor, {1});
    NEEDS(clq_actor_gaze, {3}, crowd(), actor, {1}, nullptr, 1);
    NEEDS(clq_actor_express, none, crowd(), actor, {2}, 0, 1);
    NEEDS(clq_actor_say, none, crowd(), actor, {4}, 1);
    NEEDS(clq_crowd_add_root_path, none, crowd(), &path, &made_path);
    NEEDS(clq_actor_play_root_path, none, crowd(), actor, &path_play);
}

}  // namespace
