// Actors on tracks through whole updates: what is shown follows the track, feet stay where they stand in every cache
// mode, and any frame can be shown by itself.
#include "tests/api/walkers.h"

#include "tests/api/saved_bytes.h"

using walkers::Walkers;

namespace
{

double apart(const std::vector<double> &a, const std::vector<double> &b)
{
    return std::hypot(a[0] - b[0], a[2] - b[2]);
}

}  // namespace

TEST_F(Walkers, AppearWithTheirTrackAndDisappearWithIt)
{
    clq_crowd *crowd = this->crowd();
    walker(crowd, track(1, 0), 100);
    clq_view *view = this->view(crowd, 12);
    for (const auto &[time_s, seen] :
         {std::pair<double, uint32_t>{99.9, 0}, {100.1, 1}, {108, 1}, {115.9, 1}, {116.1, 0}}) {
        ASSERT_EQ(clq_crowd_update(crowd, time_s, &view, 1), CLQ_OK) << clq_last_error();
        EXPECT_EQ(visible(view), seen) << time_s;
    }
}

TEST_F(Walkers, AreWhereTheirTrackIs)
{
    clq_crowd *crowd = this->crowd();
    clq_track *track = this->track(1.2, 0, 1);
    const clq_actor actor = walker(crowd, track);
    clq_view *view = this->view(crowd, 12);
    for (double t = 0; t < 16; t += 0.7) {
        ASSERT_EQ(clq_crowd_update(crowd, t, &view, 1), CLQ_OK);
        clq_actor_info info = clq_actor_info_init();
        ASSERT_EQ(clq_actor_get_info(crowd, actor, &info), CLQ_OK);
        clq_track_state state;
        ASSERT_EQ(clq_track_evaluate(track, t, &state), CLQ_OK);
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(info.root.position[k], state.position[k], 1e-9) << t;
    }
}

// What a viewer sees of a foot that stands: frames at 25 a second, each with the pose of its tick on the Reference
// Point of its time.
TEST_F(Walkers, FeetThatStandSlideByLessThan20MmOrAPixelInEveryCacheMode)
{
    clq_locomotion_info measured = clq_locomotion_info_init();
    ASSERT_EQ(clq_locomotion_get_info(locomotion_, &measured), CLQ_OK);
    clq_crowd_def defs[4];
    for (clq_crowd_def &def : defs) def = clq_crowd_def_init();
    defs[1].cache = CLQ_CACHE_ANIMATION;
    defs[2].cache = CLQ_CACHE_NONE;
    defs[3].key_poses.bands[0] = {0, CLQ_KEY_POSE_INTERPOLATED}, defs[3].key_poses.band_count = 1;
    clq_track *track = this->track(1.3, 0, 1.5);
    for (const clq_crowd_def &def : defs)
        for (const double distance : {3.0, 10.0, 30.0, 60.0}) {
            clq_crowd *crowd = this->crowd(&def);
            const clq_actor actor = walker(crowd, track);
            clq_view *view = this->view(crowd, distance);
            const double pixel_m = distance * 1.2 / 665;
            for (int side = 0; side < 2; ++side) {
                const auto at = [&](double t) { return place(crowd, actor, measured.legs[side].toes, t); };
                std::vector<double> stands;  // where the foot is, by the track, since it began to stand
                double worst = 0;
                int stood = 0;
                for (double t = 0.04; t < 15.9; t += 0.04) {
                    ASSERT_EQ(clq_crowd_update(crowd, t, &view, 1), CLQ_OK);
                    const bool still = apart(at(t - 0.03), at(t + 0.03)) < 0.002;
                    if (!still || !visible(view)) {
                        stands.clear();
                        continue;
                    }
                    const std::vector<double> shown = at(NAN);
                    if (stands.empty()) stands = at(t);
                    worst = std::max(worst, apart(shown, stands));
                    ++stood;
                }
                EXPECT_LT(worst, std::max(0.020, pixel_m)) << "cache " << def.cache << " at " << distance << " m";
                if (distance > 5) {
                    EXPECT_GT(stood, 120);
                }
            }
        }
}

TEST_F(Walkers, TellWhenAndWhereTheirFeetStand)
{
    clq_locomotion_info measured = clq_locomotion_info_init();
    ASSERT_EQ(clq_locomotion_get_info(locomotion_, &measured), CLQ_OK);
    clq_crowd *crowd = this->crowd();
    clq_track *track = this->track(1.3, 0);
    const clq_actor actor = walker(crowd, track);
    for (uint32_t foot = 0; foot < 2; ++foot) {
        size_t count = 0;
        ASSERT_EQ(clq_track_get_plants(track, foot, 0.5, 4.5, nullptr, 0, &count), CLQ_OK);
        ASSERT_GE(count, 4u);
        std::vector<clq_track_plant> plants(count);
        ASSERT_EQ(clq_track_get_plants(track, foot, 0.5, 4.5, plants.data(), count, &count), CLQ_OK);
        for (size_t i = 0; i < count; ++i) {
            const clq_track_plant &plant = plants[i];
            EXPECT_LT(plant.begin_s, plant.end_s);
            EXPECT_GE(plant.end_s, 0.5);
            EXPECT_LE(plant.begin_s, 4.5);
            if (i > 0) {
                EXPECT_GT(plant.begin_s, plants[i - 1].end_s);
            }
            const double middle_s = (plant.begin_s + plant.end_s) / 2;
            const std::vector<double> shown = place(crowd, actor, measured.legs[foot].toes, middle_s);
            EXPECT_LT(std::hypot(shown[0] - plant.position[0], shown[2] - plant.position[2]), 0.06);
            EXPECT_LT(apart(shown, place(crowd, actor, measured.legs[foot].toes, middle_s + 0.08)), 0.01);
        }
        EXPECT_EQ(clq_track_get_plants(track, foot, 0.5, 4.5, plants.data(), count - 1, &count), CLQ_LIMIT);
        EXPECT_EQ(clq_track_get_plants(track, foot, 100, 200, nullptr, 0, &count), CLQ_OK);
        EXPECT_EQ(count, 0u);
    }
    size_t count = 0;
    EXPECT_EQ(clq_track_get_plants(track, 2, 0, 1, nullptr, 0, &count), CLQ_ARGUMENT);
    EXPECT_EQ(clq_track_get_plants(track, 0, NAN, 1, nullptr, 0, &count), CLQ_ARGUMENT);
}

TEST_F(Walkers, SlideWithoutTheRuleForWhatMoves)
{
    clq_locomotion_info measured = clq_locomotion_info_init();
    ASSERT_EQ(clq_locomotion_get_info(locomotion_, &measured), CLQ_OK);
    clq_crowd_def def = clq_crowd_def_init();
    def.motion_tolerance_px = 0;
    clq_crowd *crowd = this->crowd(&def);
    const clq_actor actor = walker(crowd, track(1.3, 0));
    clq_view *view = this->view(crowd, 60);
    double worst = 0;
    std::vector<double> before;
    for (double t = 1; t < 4; t += 0.04) {
        ASSERT_EQ(clq_crowd_update(crowd, t, &view, 1), CLQ_OK);
        const uint32_t toes = measured.legs[0].toes;
        const bool still = apart(place(crowd, actor, toes, t - 0.03), place(crowd, actor, toes, t + 0.03)) < 0.002;
        const std::vector<double> shown = place(crowd, actor, toes, NAN);
        if (still && before.empty()) before = shown;
        if (still) worst = std::max(worst, apart(shown, before));
        else before.clear();
    }
    EXPECT_GT(worst, 0.2);
}

TEST_F(Walkers, PlayAClipOfTheirOwnAndWalkOn)
{
    clq_crowd *crowd = this->crowd();
    clq_track *way = track(1.2, 0);
    const clq_actor actor = walker(crowd, way), other = walker(crowd, way);
    clq_fade_def wave = clq_fade_def_init();
    wave.play.clip = clq_template_find_clip(citizen_, "stand_wave"), wave.at_s = 5.5;
    ASSERT_EQ(clq_actor_fade_to(crowd, actor, &wave), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_actor_fade_to_track(crowd, actor, 7.5, 0.4f), CLQ_OK) << clq_last_error();
    const uint32_t hand = clq_template_find_node(citizen_, "hand_r");
    EXPECT_LT(apart(place(crowd, actor, hand, 3), place(crowd, other, hand, 3)), 0.05);
    EXPECT_GT(std::fabs(place(crowd, actor, hand, 6.7)[1] - place(crowd, other, hand, 6.7)[1]), 0.3);
    EXPECT_LT(apart(place(crowd, actor, hand, 11), place(crowd, other, hand, 11)), 0.05);
    const uint32_t root = 0;
    EXPECT_LT(apart(place(crowd, actor, root, 6.7), place(crowd, other, root, 6.7)), 1e-6)
        << "the track still moves it";
}

TEST_F(Walkers, StayWhereTheyLeaveTheirTrack)
{
    clq_crowd *crowd = this->crowd();
    clq_track *way = track(1.2, 0);
    const clq_actor actor = walker(crowd, way);
    clq_track_state state;
    ASSERT_EQ(clq_track_evaluate(way, 3, &state), CLQ_OK);
    ASSERT_EQ(clq_actor_leave_track(crowd, actor, 3), CLQ_OK) << clq_last_error();
    for (const double t : {0.0, 3.0, 100.0}) EXPECT_NEAR(place(crowd, actor, 0, t)[0], state.position[0], 1e-6) << t;
    EXPECT_EQ(clq_actor_leave_track(crowd, actor, 3), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_fade_to_track(crowd, actor, 3, 1), CLQ_ARGUMENT);
}

TEST_F(Walkers, AreInNoGroup)
{
    clq_crowd *crowd = this->crowd();
    clq_track *way = track(1.2, 0);
    const clq_actor actor = walker(crowd, way);
    clq_group group;
    ASSERT_EQ(clq_group_create(crowd, nullptr, &group), CLQ_OK);
    EXPECT_EQ(clq_actor_join(crowd, actor, group, nullptr), CLQ_ARGUMENT);
    ASSERT_EQ(clq_actor_leave_track(crowd, actor, 1), CLQ_OK);
    ASSERT_EQ(clq_actor_join(crowd, actor, group, nullptr), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_actor_follow_track(crowd, actor, way, 0), CLQ_ARGUMENT);
}

TEST_F(Walkers, OfAnotherTemplateOrContextAreRefused)
{
    clq_crowd *crowd = this->crowd();
    clq_template *patrician = nullptr;
    ASSERT_EQ(clq_template_builtin(context_, "patrician", &patrician), CLQ_OK);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = patrician;
    clq_actor actor;
    ASSERT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK);
    clq_template_destroy(patrician);
    clq_track *way = track(1, 0);
    EXPECT_EQ(clq_actor_follow_track(crowd, actor, way, 0), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("citizen"), std::string::npos) << clq_last_error();
    EXPECT_EQ(clq_actor_follow_track(crowd, actor, nullptr, 0), CLQ_ARGUMENT);
    EXPECT_EQ(clq_actor_follow_track(crowd, walker(crowd, way), way, NAN), CLQ_ARGUMENT);
}

TEST_F(Walkers, GoOnFromASavedCrowd)
{
    clq_track *way = track(1.2, 0, 1);
    clq_crowd *crowd = this->crowd(), *other = this->crowd();
    walker(crowd, way, 1);
    const saved::Bytes bytes = saved::save(crowd);
    EXPECT_EQ(clq_crowd_restore(other, bytes.data(), bytes.size(), &citizen_, 1), CLQ_ARGUMENT);
    ASSERT_EQ(clq_crowd_add_track(other, way), CLQ_OK);
    ASSERT_EQ(clq_crowd_restore(other, bytes.data(), bytes.size(), &citizen_, 1), CLQ_OK) << clq_last_error();
    clq_view *a = view(crowd, 9), *b = view(other, 9);
    for (double t = 2; t < 14; t += 1.1) {
        ASSERT_EQ(clq_crowd_update(crowd, t, &a, 1), CLQ_OK);
        ASSERT_EQ(clq_crowd_update(other, t, &b, 1), CLQ_OK);
        EXPECT_EQ(clq_view_get_hash(a), clq_view_get_hash(b)) << t;
    }
}

// Steps and stands against the tracks themselves: feet come down where the state has weight on them.
TEST_F(Walkers, TellWhenTheyStepAndWhenTheyStand)
{
    clq_crowd *crowd = this->crowd();
    clq_track *track = this->track(1.2, 0);
    const clq_actor actor = walker(crowd, track, 100);
    ASSERT_EQ(clq_actor_set_watched(crowd, actor, true), CLQ_OK);
    const auto events = [&](double from_s, double to_s) {
        const clq_time_range range = {from_s, to_s};
        std::vector<clq_event> out(500);
        size_t count = 0;
        EXPECT_EQ(clq_crowd_get_events(crowd, &range, out.data(), out.size(), &count), CLQ_OK) << clq_last_error();
        out.resize(count);
        return out;
    };
    const std::vector<clq_event> all = events(90, 130);
    int steps[2] = {0, 0}, stands = 0;
    double stood_s = 0;
    for (const clq_event &e : all) {
        if (e.kind == CLQ_EVENT_STEP) {
            ASSERT_LT(e.marker, 2u);
            ++steps[e.marker];
        } else {
            ASSERT_EQ(e.kind, CLQ_EVENT_STAND) << "nothing else happens on a track";
            ++stands, stood_s = e.time_s - 100;
        }
    }
    // 13 s of walking with some 1.1 s from one step of a foot to the next, and one stand from the fifth second on.
    for (const int count : steps) EXPECT_NEAR(count, 12, 3);
    EXPECT_EQ(stands, 1);
    clq_track_state before, after;
    ASSERT_EQ(clq_track_evaluate(track, stood_s - 0.2, &before), CLQ_OK);
    ASSERT_EQ(clq_track_evaluate(track, stood_s + 0.2, &after), CLQ_OK);
    EXPECT_FALSE(before.stands);
    EXPECT_TRUE(after.stands);
    size_t in_parts = 0;
    for (int i = 0; i < 4000; ++i) in_parts += events(90 + 0.01 * i, 90 + 0.01 * (i + 1)).size();
    EXPECT_EQ(in_parts, all.size());
    // Clips of its own instead of the gait: no steps.
    clq_play play = clq_play_init();
    play.clip = clq_template_find_clip(citizen_, "stand");
    ASSERT_EQ(clq_actor_play(crowd, actor, &play), CLQ_OK) << clq_last_error();
    for (const clq_event &e : events(90, 130)) EXPECT_NE(e.kind, CLQ_EVENT_STEP);
}

// What is drawn is what clq_actor_get_node says, and both look ahead of a turn.
TEST_F(Walkers, LookWhereTheyWillGo)
{
    clq_crowd *crowd = this->crowd();
    clq_track *track = this->track(1.2, 0, 2);
    const clq_actor actor = walker(crowd, track);
    clq_view *view = this->view(crowd, 8);
    const uint32_t head = clq_template_find_node(citizen_, "head");
    std::vector<float> palette(12 * 33);
    double most = 0;
    for (double t = 0.5; t < 12; t += 0.25) {
        ASSERT_EQ(clq_crowd_update(crowd, t, &view, 1), CLQ_OK);
        if (visible(view) == 0) continue;
        ASSERT_EQ(clq_view_get_palette(view, 0, palette.data(), 33), CLQ_OK) << clq_last_error();
        double node[16] = {};
        ASSERT_EQ(clq_actor_get_node(crowd, actor, head, t, node), CLQ_OK) << clq_last_error();
        clq_track_state state;
        ASSERT_EQ(clq_track_evaluate(track, t, &state), CLQ_OK);
        // The third column of each: the people's rest pose has no rotations.
        const double drawn = std::atan2(double(palette[12 * head + 6]), double(palette[12 * head + 8]));
        const double told = std::atan2(node[8], node[10]) - state.heading_rad;
        EXPECT_NEAR(std::remainder(drawn - told, 6.283185307), 0, 0.03) << t;  // it is of a tick before t
        most = std::max(most, std::fabs(drawn));
    }
    EXPECT_GT(most, 0.3);
}
