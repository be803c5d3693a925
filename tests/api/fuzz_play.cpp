// Random calls about blending: gaits, masks, fades, layers and events.
#include "tests/api/calls.h"
#include "tests/api/fuzz_world.h"

namespace fuzz
{

void World::describe_play()
{
    if (gaits_ + masks_ > 20) return;
    const clq_template *tmpl = random_.one_in(40) ? nullptr : templates_[random_.below(4)];
    clq_gait_def gait = clq_gait_def_init();
    gait.tmpl = tmpl, gait.clip_a = random_.index(1), gait.clip_b = random_.index(1);
    const float sync_a[2] = {random_.oddf(0, 0.4), random_.oddf(0.4, 0.9)},
                sync_b[2] = {random_.oddf(0, 0.4), random_.oddf(0.4, 1)};
    gait.sync_count = random_.below(3), gait.sync_a_s = sync_a, gait.sync_b_s = sync_b;
    if (random_.one_in(10)) gait.sync_marker = "down";
    clq_gait made_gait;
    gaits_ += call("clq_crowd_add_gait", [&] { return clq_crowd_add_gait(crowd_, &gait, &made_gait); });
    const char *names[2] = {random_.one_in(20) ? nullptr : "tip", random_.one_in(10) ? "nobody" : "root"};
    clq_mask_def mask = clq_mask_def_init();
    mask.tmpl = tmpl, mask.node_count = random_.index(2), mask.nodes = names, mask.feather = random_.below(3);
    if (mask.node_count > 2) mask.node_count = 2;
    mask.inverted = random_.below(2);
    clq_mask made_mask;
    masks_ += call("clq_crowd_add_mask", [&] { return clq_crowd_add_mask(crowd_, &mask, &made_mask); });
}

void World::blend()
{
    const clq_actor id = person();
    clq_fade_def to = clq_fade_def_init();
    to.play = {random_.index(1), random_.odd(-5, 30), random_.oddf(-2, 2), random_.oddf(-2, 2)};
    if (random_.one_in(2)) to.gait = {random_.index(gaits_ + 1)}, to.share = random_.oddf(0, 1);
    const double at_s = random_.odd(-5, 30);
    const float length_s = random_.oddf(0, 3);
    // one more than the type has, so that an invalid value occurs
    const auto curve = static_cast<clq_curve>(random_.below(4));
    call("clq_actor_fade_to", [&] { return api_test::fade_to(crowd_, id, to, at_s, length_s, curve); });
    const float share = random_.oddf(0, 1);
    if (random_.one_in(2))
        call("clq_actor_set_gait_share", [&] { return clq_actor_set_gait_share(crowd_, id, share, at_s, length_s); });
    clq_layer_def def = clq_layer_def_init();
    def.kind = static_cast<clq_layer_kind>(random_.index(2)), def.play = to.play;
    def.weight = random_.oddf(0, 1), def.loops = random_.oddf(0, 3), def.fade_in_s = random_.oddf(0, 1);
    def.fade_out_s = random_.oddf(0, 1), def.mask = {random_.index(masks_ + 1)};
    def.has_reference = random_.below(2), def.reference_clip = random_.index(1),
    def.reference_time_s = random_.oddf(0, 1);
    clq_layer layer = {1 + random_.below(200)};
    call("clq_actor_add_layer", [&] { return clq_actor_add_layer(crowd_, id, &def, &layer); });
    if (random_.one_in(2))
        call("clq_actor_end_layer", [&] { return clq_actor_end_layer(crowd_, id, layer, at_s, length_s); });
}

// Tracks: followed, left and returned to, with templates and groups for which they are not.
void World::follow()
{
    const clq_actor id = person();
    clq_track *track = random_.one_in(30) ? nullptr : test_world_.tracks[random_.below(2)];
    const double at_s = random_.odd(-5, 30);
    switch (random_.below(5)) {
        case 0:
            call("clq_actor_leave_track", [&] { return clq_actor_leave_track(crowd_, id, at_s); });
            break;
        case 1: {
            const float length_s = random_.oddf(0, 3);
            call("clq_actor_fade_to_track", [&] { return clq_actor_fade_to_track(crowd_, id, at_s, length_s); });
            break;
        }
        case 2:
            call("clq_crowd_add_track", [&] { return clq_crowd_add_track(crowd_, track); });
            break;
        default:
            call("clq_actor_follow_track", [&] { return clq_actor_follow_track(crowd_, id, track, at_s); });
    }
    clq_track_state state;
    const double when = random_.odd(-5, 30);
    call("clq_track_evaluate", [&] { return clq_track_evaluate(track, when, &state); });
    clq_track_plant plants[4];
    size_t plant_count = 0;
    const uint32_t foot = random_.below(3);
    call("clq_track_get_plants",
         [&] { return clq_track_get_plants(track, foot, when, when + 2, plants, random_.below(5), &plant_count); });
}

void World::watch()
{
    const clq_actor id = person();
    const int32_t watched = !random_.one_in(3);
    call("clq_actor_set_watched", [&] { return clq_actor_set_watched(crowd_, id, watched); });
    clq_event events[200];
    size_t count = 0;
    const double from = random_.odd(-5, 30), to = random_.odd(-5, 30);
    if (call("clq_crowd_get_events", [&] { return api_test::get_events(crowd_, from, to, events, 200, &count); }))
        for (size_t i = 0; i < count; ++i) {
            EXPECT_GT(events[i].time_s, from);
            EXPECT_LE(events[i].time_s, to);
            if (i > 0) {
                EXPECT_LE(events[i - 1].time_s, events[i].time_s);
            }
        }
    clq_view_change changes[200];
    if (call("clq_crowd_get_view_changes", [&] { return clq_crowd_get_view_changes(crowd_, changes, 200, &count); }))
        for (size_t i = 1; i < count; ++i) {
            EXPECT_LT(changes[i - 1].actor.index1, changes[i].actor.index1);
        }
    clq_active_clip shown[CLQ_ACTIVE_CLIP_MAX];
    uint32_t shown_count = 0;
    const double at_s = random_.odd(-5, 30);
    call("clq_actor_get_active_clips",
         [&] { return clq_actor_get_active_clips(crowd_, id, at_s, shown, &shown_count); });
    EXPECT_LE(shown_count, uint32_t(CLQ_ACTIVE_CLIP_MAX));
    clq_random_play_def def = clq_random_play_def_init();
    const uint32_t clips[2] = {random_.index(1), random_.index(1)};
    const float weights[2] = {random_.oddf(0, 1), random_.oddf(0, 1)};
    def.clip_count = random_.below(3), def.clips = clips, def.weights = random_.one_in(2) ? weights : nullptr;
    def.speed_spread = random_.oddf(0, 0.9), def.phase_spread = random_.oddf(0, 1);
    clq_play play;
    call("clq_actor_sample_play", [&] { return api_test::sample_play(crowd_, id, def, 3, at_s, &play); });
}

}  // namespace fuzz
