#include "tests/api/record_calls.h"

#include "tests/api/calls.h"

namespace records
{

Stage::Stage()
{
    world.set_up(crowd);
    for (clq_actor *made : {&actor, &member, &other}) {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = world.templates[made == &other];
        def.seed = 5 + static_cast<uint64_t>(made - &actor);
        EXPECT_EQ(clq_actor_create(crowd, &def, made), CLQ_OK);
    }
    const clq_transform place = clq_transform_init();
    for (clq_group *made : {&group, &empty}) EXPECT_EQ(clq_group_create(crowd, &place, made), CLQ_OK);
    EXPECT_EQ(clq_actor_join(crowd, member, group, nullptr), CLQ_OK);
    const float centre[3] = {0, 0, 0};
    EXPECT_EQ(api_test::attach(crowd, actor, 1, centre, 1, &attachment), CLQ_OK);
    for (const uint32_t kind : {TestWorld::gaze, TestWorld::expression, TestWorld::phrase}) {
        const clq_mechanism_attachment use = {{kind + 1}, 0, 0, 0};
        EXPECT_EQ(clq_actor_attach_mechanism(crowd, actor, &use), CLQ_OK) << clq_last_error();
    }
    clq_fade_def fade = clq_fade_def_init();
    fade.gait = {1};
    EXPECT_EQ(api_test::fade_to(crowd, actor, fade, 0, 1, CLQ_CURVE_SMOOTH), CLQ_OK) << clq_last_error();
    clq_layer_def def = clq_layer_def_init();
    def.play.clip = 0;
    EXPECT_EQ(clq_actor_add_layer(crowd, actor, &def, &layer), CLQ_OK) << clq_last_error();
    state = saved::save(crowd);
    clq_colour_class one = clq_colour_class_init();
    one.name = "one";
    clq_colour_map_def colours = clq_colour_map_def_init();
    colours.class_count = 1, colours.classes = &one;
    EXPECT_EQ(clq_colour_map_create(world.context, &colours, &map), CLQ_OK) << clq_last_error();
}

namespace
{

std::vector<Recorded> calls_of_actors()
{
    using S = Stage &;
    static const clq_transform place = {{1, 2, -3}, {0, 0, 0, 1}, 1.5f};
    return {
        {"clq_actor_create",
         [](S s) {
             clq_actor_def def = clq_actor_def_init();
             def.tmpl = s.world.templates[1], def.transform = place, def.play = {0, 2, 0.5f, 0.25f};
             def.seed = 77, def.texture_set = CLQ_RANDOM;
             clq_actor made;
             return clq_actor_create(s.crowd, &def, &made);
         }},
        {"clq_actor_destroy", [](S s) { return clq_actor_destroy(s.crowd, s.member); }},
        {"clq_actor_clone",
         [](S s) {
             clq_actor made;
             return clq_actor_clone(s.crowd, s.member, &place, 9, &made);
         }},
        {"clq_crowd_set_transforms",
         [](S s) {
             const clq_actor actors[2] = {s.other, s.member};
             const clq_transform places[2] = {place, clq_transform_init()};
             return clq_crowd_set_transforms(s.crowd, actors, places, 2);
         }},
        {"clq_actor_set_colours",
         [](S s) {
             const float rgb[6] = {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 1};
             return clq_actor_set_colours(s.crowd, s.actor, rgb, 2);
         }},
        {"clq_actor_randomise_colours", [](S s) { return clq_actor_randomise_colours(s.crowd, s.actor, nullptr, 0); }},
        {"clq_crowd_randomise_colours",
         [](S s) {
             const clq_actor actors[2] = {s.other, s.member};
             return clq_crowd_randomise_colours(s.crowd, s.map, 0, actors, 2);
         }},
        {"clq_actor_set_texture_set", [](S s) { return clq_actor_set_texture_set(s.crowd, s.actor, CLQ_RANDOM); }},
        {"clq_actor_set_priority", [](S s) { return clq_actor_set_priority(s.crowd, s.actor, 0.625f); }},
        {"clq_actor_attach",
         [](S s) {
             const float centre[3] = {0.5f, 1, 2};
             return api_test::attach(s.crowd, s.member, 1, centre, 3, nullptr);
         }},
        {"clq_actor_detach", [](S s) { return clq_actor_detach(s.crowd, s.attachment); }},
        {"clq_actor_join", [](S s) { return clq_actor_join(s.crowd, s.other, s.group, &place); }},
        {"clq_group_create",
         [](S s) {
             clq_group made;
             return clq_group_create(s.crowd, &place, &made);
         }},
        {"clq_group_destroy", [](S s) { return clq_group_destroy(s.crowd, s.group); }},
        {"clq_group_set_transform", [](S s) { return clq_group_set_transform(s.crowd, s.group, &place); }},
        {"clq_group_set_speed", [](S s) { return clq_group_set_speed(s.crowd, s.group, 1.5f); }},
        {"clq_crowd_set_speeds",
         [](S s) {
             const clq_actor actors[2] = {s.other, s.member};
             const float speeds[2] = {0.75f, 2};
             return clq_crowd_set_speeds(s.crowd, actors, speeds, 2);
         }},
        {"clq_group_set_enabled", [](S s) { return clq_group_set_enabled(s.crowd, s.group, false); }},
        {"clq_crowd_restore",
         [](S s) { return clq_crowd_restore(s.crowd, s.state.data(), s.state.size(), s.world.templates, 2); }}};
}

std::vector<Recorded> calls_of_plays()
{
    using S = Stage &;
    return {{"clq_actor_play",
             [](S s) {
                 const clq_play play = {0, 1, 2, 0.5f};
                 return clq_actor_play(s.crowd, s.actor, &play);
             }},
            {"clq_actor_fade_to",
             [](S s) {
                 clq_fade_def def = clq_fade_def_init();
                 def.play = {0, 2, 1.5f, 0.25f};
                 return api_test::fade_to(s.crowd, s.member, def, 3, 0.5f, CLQ_CURVE_INERTIAL);
             }},
            {"clq_actor_set_gait_share", [](S s) { return clq_actor_set_gait_share(s.crowd, s.actor, 0.75f, 2, 1); }},
            {"clq_actor_add_layer",
             [](S s) {
                 clq_layer_def def = clq_layer_def_init();
                 def.kind = CLQ_LAYER_ADD, def.play = {0, 1, 1, 0.5f}, def.weight = 2, def.loops = 3;
                 def.fade_in_s = 0.25f, def.fade_out_s = 0.5f, def.curve = CLQ_CURVE_LINEAR, def.mask = {1};
                 def.has_reference = true, def.reference_clip = 0, def.reference_time_s = 0.125f;
                 return clq_actor_add_layer(s.crowd, s.actor, &def, nullptr);
             }},
            {"clq_actor_end_layer", [](S s) { return clq_actor_end_layer(s.crowd, s.actor, s.layer, 4, 0.5f); }},
            {"clq_actor_set_watched", [](S s) { return clq_actor_set_watched(s.crowd, s.actor, true); }},
            {"clq_crowd_add_gait",
             [](S s) {
                 clq_gait_def def = clq_gait_def_init();
                 const float a[2] = {0.1f, 0.3f}, b[2] = {0.2f, 0.4f};
                 def.tmpl = s.world.templates[0], def.sync_count = 2, def.sync_a_s = a, def.sync_b_s = b;
                 clq_gait made;
                 return clq_crowd_add_gait(s.crowd, &def, &made);
             }},
            {"clq_crowd_add_mask",
             [](S s) {
                 clq_mask_def def = clq_mask_def_init();
                 const char *tip = "tip";
                 def.tmpl = s.world.templates[0], def.node_count = 1, def.nodes = &tip, def.inverted = true;
                 clq_mask made;
                 return clq_crowd_add_mask(s.crowd, &def, &made);
             }},
            {"clq_actor_follow_track",
             [](S s) { return clq_actor_follow_track(s.crowd, s.actor, s.world.tracks[1], 2.5); }},
            {"clq_actor_fade_to_track",
             [](S s) {
                 const clq_play play = {0, 1, 2, 0.5f};
                 const clq_status followed = clq_actor_follow_track(s.crowd, s.actor, s.world.tracks[0], 1);
                 clq_actor_play(s.crowd, s.actor, &play);
                 return followed == CLQ_OK ? clq_actor_fade_to_track(s.crowd, s.actor, 2, 0.5f) : followed;
             }},
            {"clq_actor_leave_track", [](S s) {
                 const clq_status followed = clq_actor_follow_track(s.crowd, s.actor, s.world.tracks[0], 1);
                 return followed == CLQ_OK ? clq_actor_leave_track(s.crowd, s.actor, 2) : followed;
             }}};
}

std::vector<Recorded> calls_of_behaviour()
{
    using S = Stage &;
    static const double point[3] = {1, 2, 3};
    return {{"clq_crowd_add_mechanism",
             [](S s) {
                 const clq_mechanism_def def = s.world.mechanism(TestWorld::phrase);
                 clq_mechanism made;
                 return clq_crowd_add_mechanism(s.crowd, &def, &made);
             }},
            {"clq_actor_attach_mechanism",
             [](S s) {
                 const clq_mechanism_attachment use = {{TestWorld::idle + 1}, 2, 0.5f, 1};
                 return clq_actor_attach_mechanism(s.crowd, s.actor, &use);
             }},
            {"clq_actor_detach_mechanism",
             [](S s) { return clq_actor_detach_mechanism(s.crowd, s.actor, {TestWorld::gaze + 1}); }},
            {"clq_actor_gaze", [](S s) { return clq_actor_gaze(s.crowd, s.actor, {TestWorld::gaze + 1}, point, 3); }},
            {"clq_actor_express",
             [](S s) { return clq_actor_express(s.crowd, s.actor, {TestWorld::expression + 1}, 1, 3); }},
            {"clq_actor_say", [](S s) { return clq_actor_say(s.crowd, s.actor, {TestWorld::phrase + 1}, 3); }},
            {"clq_crowd_add_root_path",
             [](S s) {
                 const clq_root_path_def def = s.world.path(false);
                 clq_root_path made;
                 return clq_crowd_add_root_path(s.crowd, &def, &made);
             }},
            {"clq_actor_play_root_path",
             [](S s) {
                 const clq_root_path_play play = {{2}, 0.5f, 0.25f, 3};
                 return clq_actor_play_root_path(s.crowd, s.actor, &play);
             }},
            {"clq_actor_follow_ground", [](S s) { return clq_actor_follow_ground(s.crowd, s.actor, 2, 3); }},
            {"clq_crowd_update", [](S s) { return clq_crowd_update(s.crowd, 5, nullptr, 0); }}};
}

}  // namespace

std::vector<Recorded> recorded_calls()
{
    std::vector<Recorded> all = calls_of_actors();
    for (const auto &part : {calls_of_plays(), calls_of_behaviour()}) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace records
