// Events, compared with a walk through time in small steps.
#include <cmath>
#include <tuple>

#include "tests/api/arm.h"
#include "tests/api/calls.h"

namespace
{

TEST(Events, ComeInTheOrderOfTimeForAnyIntervals)
{
    Arm arm;
    EXPECT_TRUE(arm.events(0, 100).empty()) << "no actor is watched";
    ASSERT_EQ(clq_actor_set_watched(arm.crowd, arm.actor, 1), CLQ_OK);
    arm.fade(Arm::fast, 5.1, 0.5f);
    clq_layer_def layer = clq_layer_def_init();
    layer.play.clip = Arm::wave, layer.play.start_s = 6.05, layer.loops = 3;
    ASSERT_EQ(clq_actor_add_layer(arm.crowd, arm.actor, &layer, nullptr), CLQ_OK);
    const std::vector<clq_event> all = arm.events(0, 10);
    for (size_t i = 1; i < all.size(); ++i) EXPECT_LE(all[i - 1].time_s, all[i].time_s);
    std::vector<clq_event> parts;
    for (int i = 0; i < 1000; ++i)
        for (const clq_event &e : arm.events(0.01 * i, 0.01 * (i + 1))) parts.push_back(e);
    ASSERT_EQ(parts.size(), all.size());
    for (size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(parts[i].time_s, all[i].time_s);
        EXPECT_EQ(parts[i].kind, all[i].kind);
        EXPECT_EQ(parts[i].loop, all[i].loop);
    }
    EXPECT_TRUE(arm.events(9, 3).empty()) << "time that has jumped back";

    // Slow from 0 to 5.1: 2 loops, markers at 0.5 and 1.25; fast from 5.1 to 10: 4 loops and 4 markers, from 0.25 on.
    int ends[Arm::clip_count] = {}, markers[Arm::clip_count] = {}, fades = 0, layers = 0;
    for (const clq_event &e : all) {
        if (e.kind == CLQ_EVENT_CLIP_END) {
            EXPECT_EQ(e.loop, uint64_t(++ends[e.clip])) << e.time_s;
        }
        if (e.kind == CLQ_EVENT_MARKER) {
            ++markers[e.clip];
            clq_marker_info info = clq_marker_info_init();
            ASSERT_EQ(clq_template_get_marker(arm.tmpl, e.marker, &info), CLQ_OK);
            EXPECT_STREQ(info.name, "down");
            EXPECT_EQ(info.clip, e.clip);
        }
        fades += e.kind == CLQ_EVENT_FADE_END && std::fabs(e.time_s - 5.6) < 1e-6;
        layers += e.kind == CLQ_EVENT_LAYER_END && std::fabs(e.time_s - 7.55) < 1e-6;
    }
    EXPECT_EQ(ends[Arm::slow], 2);
    EXPECT_EQ(markers[Arm::slow], 5);
    EXPECT_EQ(ends[Arm::fast], 4);
    EXPECT_EQ(markers[Arm::fast], 5);
    EXPECT_EQ(ends[Arm::wave], 3);
    EXPECT_EQ(fades, 1);
    EXPECT_EQ(layers, 1);
}

// With and without synchronisation points of the two clips.
class GaitEvents : public testing::TestWithParam<bool>
{
};

TEST_P(GaitEvents, FollowTheFirstClipAtItsCurrentSpeed)
{
    Arm arm;
    ASSERT_EQ(clq_actor_set_watched(arm.crowd, arm.actor, 1), CLQ_OK);
    clq_fade_def motion = arm.motion(0, 1);
    motion.gait = GetParam() ? arm.add_gait(Arm::slow, Arm::fast, {0.25f, 1.5f}, {0.5f, 0.75f})
                             : arm.add_gait(Arm::slow, Arm::fast);
    ASSERT_EQ(api_test::fade_to(arm.crowd, arm.actor, motion, 1, 0, CLQ_CURVE_SMOOTH), CLQ_OK);
    ASSERT_EQ(clq_actor_set_gait_share(arm.crowd, arm.actor, 0.5f, 4, 3), CLQ_OK);
    std::vector<double> walked;
    double last = -1;
    for (double t = 1.0005; t < 12; t += 0.0005) {
        const double a = arm.shown(t)[0].clip_time_s;
        if (last > a) walked.push_back(t);
        last = a;
    }
    std::vector<double> mentions;
    for (int i = 10; i < 120; ++i)
        for (const clq_event &e : arm.events(0.1 * i, 0.1 * (i + 1)))
            if (e.kind == CLQ_EVENT_CLIP_END && e.time_s > 1) {
                mentions.push_back(e.time_s);
                EXPECT_EQ(e.loop, mentions.size());
            }
    ASSERT_EQ(mentions.size(), walked.size());
    for (size_t i = 0; i < mentions.size(); ++i) EXPECT_NEAR(mentions[i], walked[i], 0.001);
}

INSTANTIATE_TEST_SUITE_P(Moments, GaitEvents, testing::Bool(),
                         [](const auto &test) { return test.param ? "OfTheirOwn" : "AtEqualShares"; });

// One step of two minutes over clips of a second, for several actors, compared with steps of a hundredth.
TEST(Events, OfSeveralComeInTheOrderOfTimeHoweverLongTheStep)
{
    Arm arm;
    std::vector<clq_actor> actors = {arm.actor};
    for (uint32_t i = 1; i < 5; ++i) {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = arm.tmpl;
        def.play.clip = i % Arm::clip_count;
        def.play.phase_s = 0.1f * static_cast<float>(i), def.play.speed = 1 + 0.25f * static_cast<float>(i);
        if (i == 4) def.play.speed = -1;
        actors.emplace_back();
        ASSERT_EQ(clq_actor_create(arm.crowd, &def, &actors.back()), CLQ_OK) << clq_last_error();
    }
    for (const clq_actor &actor : actors) ASSERT_EQ(clq_actor_set_watched(arm.crowd, actor, 1), CLQ_OK);
    const std::vector<clq_event> all = arm.events(0, 120);
    EXPECT_GT(all.size(), 5u * 60u);
    const auto key = [](const clq_event &e) { return std::make_tuple(e.time_s, e.actor.index1, e.kind); };
    for (size_t i = 1; i < all.size(); ++i) ASSERT_LE(key(all[i - 1]), key(all[i])) << i;
    std::vector<clq_event> parts;
    for (int i = 0; i < 12000; ++i)
        for (const clq_event &e : arm.events(0.01 * i, 0.01 * (i + 1))) parts.push_back(e);
    ASSERT_EQ(parts.size(), all.size());
    for (size_t i = 0; i < all.size(); ++i) {
        ASSERT_EQ(key(parts[i]), key(all[i])) << i;
        ASSERT_EQ(parts[i].loop, all[i].loop) << i;
        ASSERT_EQ(parts[i].marker, all[i].marker) << i;
    }
}

TEST(Events, AreBoundedAndRefusedByName)
{
    Arm arm;
    ASSERT_EQ(clq_actor_set_watched(arm.crowd, arm.actor, 1), CLQ_OK);
    size_t count = 77;
    clq_event one[1];
    EXPECT_EQ(api_test::get_events(arm.crowd, 0, 10, one, 1, &count), CLQ_LIMIT);
    EXPECT_EQ(api_test::get_events(arm.crowd, 0, 1e15, nullptr, 0, &count), CLQ_LIMIT);
    EXPECT_EQ(api_test::get_events(arm.crowd, NAN, 1, nullptr, 0, &count), CLQ_ARGUMENT);
    EXPECT_EQ(count, 77u);
    ASSERT_EQ(clq_actor_destroy(arm.crowd, arm.actor), CLQ_OK);
    EXPECT_TRUE(arm.events(0, 10).empty());
}

}  // namespace
