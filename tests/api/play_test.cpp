// Fades, gaits and layers (S2 3.3): poses compared with angles that are computed here.
#include <cmath>

#include "tests/api/arm.h"
#include "tests/api/calls.h"

namespace
{

double smooth(double x) { return x <= 0 ? 0 : x >= 1 ? 1 : x * x * (3 - 2 * x); }

// Rotations about one axis, blended as normalised quaternions.
double mixed(double a, double b, double w)
{
    return 2 *
           std::atan2((1 - w) * std::sin(a / 2) + w * std::sin(b / 2), (1 - w) * std::cos(a / 2) + w * std::cos(b / 2));
}

double in(uint32_t clip, uint32_t joint, double t)
{
    return Arm::angle_in(clip, joint,
                         std::fmod(std::fmod(t, Arm::length_s[clip]) + Arm::length_s[clip], Arm::length_s[clip]));
}

constexpr double close = 5e-3;  // radians: linear interpolation between keys plus the error of stored motion

TEST(Play, AFadeGoesFromOneClipToTheOtherOnItsCurve)
{
    Arm arm;
    arm.fade(Arm::bent, 10, 0.5f);
    arm.fade(Arm::fast, 12, 1, CLQ_CURVE_LINEAR);
    for (uint32_t joint = 0; joint < 3; ++joint) {
        for (const double t : {0.0, 9.3, 9.999})
            EXPECT_NEAR(arm.angle(joint, t), in(Arm::slow, joint, t), close) << "earlier times are unchanged";
        for (const double t : {10.0, 10.1, 10.25, 10.4, 10.499})
            EXPECT_NEAR(arm.angle(joint, t),
                        mixed(in(Arm::slow, joint, t), in(Arm::bent, joint, 0), smooth((t - 10) / 0.5)), close);
        for (const double t : {10.5, 11.0, 11.99}) EXPECT_NEAR(arm.angle(joint, t), in(Arm::bent, joint, 0), close);
        for (const double t : {12.1, 12.5, 12.9})
            EXPECT_NEAR(arm.angle(joint, t), mixed(in(Arm::bent, joint, 0), in(Arm::fast, joint, t - 12), t - 12),
                        close);
        EXPECT_NEAR(arm.angle(joint, 14.2), in(Arm::fast, joint, 2.2), close);
    }
    EXPECT_EQ(arm.shown(11).size(), 1u) << "over: one clip alone";
    EXPECT_EQ(arm.shown(10.2).size(), 2u);
}

TEST(Play, FadesIntoFadesDoNotJump)
{
    Arm arm;
    arm.fade(Arm::bent, 10, 0.5f);
    arm.fade(Arm::fast, 10.2, 0.5f);
    arm.fade(Arm::wave, 10.4, 0.3f);
    for (double t = 9.9; t < 11; t += 0.001)
        for (uint32_t joint = 0; joint < 3; ++joint)
            EXPECT_LT(std::fabs(arm.angle(joint, t + 0.001) - arm.angle(joint, t)), 0.03) << t;
    EXPECT_EQ(arm.shown(10.45).size(), 4u);
    const double between =
        mixed(mixed(in(Arm::slow, 0, 10.3), in(Arm::bent, 0, 0), smooth(0.6)), in(Arm::fast, 0, 0.1), smooth(0.2));
    EXPECT_NEAR(arm.angle(0, 10.3), between, close);
}

TEST(Play, AnInertialFadeKeepsPositionAndVelocityAndEndsInTheNewClip)
{
    Arm arm;
    arm.fade(Arm::wave, 10.3, 0.4f, CLQ_CURVE_INERTIAL);
    constexpr double h = 1e-3;
    for (uint32_t joint = 0; joint < 3; ++joint) {
        EXPECT_NEAR(arm.angle(joint, 10.3), in(Arm::slow, joint, 10.3), close);
        const double before = (in(Arm::slow, joint, 10.3) - in(Arm::slow, joint, 10.3 - 0.05)) / 0.05;
        const double after = (arm.angle(joint, 10.3 + 8 * h) - arm.angle(joint, 10.3)) / (8 * h);
        // The fade target moves by itself; part of that remains because velocities are taken over a finite step.
        const double own = std::fabs(in(Arm::wave, joint, 0.01) - in(Arm::wave, joint, 0)) / 0.01;
        EXPECT_NEAR(after, before, 0.35 + 0.15 * own) << joint;
        for (const double t : {10.7, 10.8, 12.0})
            EXPECT_NEAR(arm.angle(joint, t), in(Arm::wave, joint, t - 10.3), close);
        const double end = (arm.angle(joint, 10.7) - arm.angle(joint, 10.7 - h)) / h;
        const double clip = (in(Arm::wave, joint, 0.4) - in(Arm::wave, joint, 0.4 - h)) / h;
        EXPECT_NEAR(end, clip, 0.3 + 0.15 * own) << joint;
    }
    EXPECT_EQ(arm.shown(10.8).size(), 1u);
    // A fade that interrupts another, above a cross-fade.
    arm.fade(Arm::bent, 10.45, 0.3f, CLQ_CURVE_INERTIAL);
    for (double t = 10.2; t < 11.2; t += 0.001)
        for (uint32_t joint = 0; joint < 3; ++joint)
            EXPECT_LT(std::fabs(arm.angle(joint, t + 0.001) - arm.angle(joint, t)), 0.03) << t;
    Arm other;
    other.fade(Arm::bent, 10, 0.6f);
    other.fade(Arm::fast, 10.3, 0.3f, CLQ_CURVE_INERTIAL);
    for (double t = 9.9; t < 11.2; t += 0.001)
        EXPECT_LT(std::fabs(other.angle(0, t + 0.001) - other.angle(0, t)), 0.03) << t;
}

TEST(Play, GaitsStaySynchronisedAtAnyShareAndThroughItsChanges)
{
    Arm arm;
    clq_fade_def motion = arm.motion(0, 10);
    motion.gait = arm.add_gait(Arm::slow, Arm::fast, {0.25f, 1.5f}, {0.5f, 0.75f});
    ASSERT_EQ(api_test::fade_to(arm.crowd, arm.actor, motion, 10, 0, CLQ_CURVE_SMOOTH), CLQ_OK) << clq_last_error();
    EXPECT_EQ(arm.shown(10.3).size(), 1u) << "a share of 0";
    ASSERT_EQ(clq_actor_set_gait_share(arm.crowd, arm.actor, 0.75f, 12, 2), CLQ_OK) << clq_last_error();
    // Synchronised phases meet: whenever slow is at 0.25, fast is at 0.5.
    double last = -1;
    int met = 0;
    for (double t = 12.1; t < 20; t += 0.0005) {
        const auto clips = arm.shown(t);
        ASSERT_EQ(clips.size(), 2u);
        const double a = clips[0].clip_time_s, b = clips[1].clip_time_s;
        const double share = a < 0.25  ? (a + 2 - 1.5) / 0.75 * 0.5 + 0.5
                             : a < 1.5 ? (a - 0.25) / 1.25 * 0.5
                                       : (a - 1.5) / 0.75 * 0.5 + 0.5;
        const double expected = std::fmod(share < 0.5 ? 0.5 + share * 0.5 : 0.75 + (share - 0.5) * 1.5, 1.0);
        EXPECT_NEAR(std::remainder(b - expected, 1.0), 0, 1e-6) << t;
        if (last >= 0) {
            EXPECT_GT(std::remainder(a - last, 2.0), 0) << "the phase goes on";
            EXPECT_LT(std::remainder(a - last, 2.0), 0.0025);
            met += a < last;
        }
        last = a;
    }
    // From 0.5 to 0.875 loops a second: 1 s at the mean of both; 0.05 s of the change are not sampled.
    EXPECT_NEAR(met, 0.5 * (2 + 6) + 0.375 * (1 + 6), 1.0);
    const auto clips = arm.shown(16);
    EXPECT_NEAR(clips[1].weight, 0.75, 1e-6);
    const double expected = mixed(in(Arm::slow, 1, clips[0].clip_time_s), in(Arm::fast, 1, clips[1].clip_time_s), 0.75);
    EXPECT_NEAR(arm.angle(1, 16), expected, close);
    EXPECT_EQ(api_test::fade_to(arm.crowd, arm.actor, motion, 21, 1, CLQ_CURVE_INERTIAL), CLQ_UNSUPPORTED);
}

TEST(Play, AGaitBeginsAtThePhaseOfItsFirstClipForAnySynchronisation)
{
    Arm arm;
    clq_fade_def motion = arm.motion(0, 10);
    motion.gait = arm.add_gait(Arm::slow, Arm::fast, {0.25f, 1.5f}, {0.5f, 0.75f});
    for (const float phase_s : {0.0f, 0.25f, 0.9f, 1.75f}) {
        motion.play.phase_s = phase_s, motion.share = 0.5f;
        ASSERT_EQ(api_test::fade_to(arm.crowd, arm.actor, motion, 10, 0, CLQ_CURVE_SMOOTH), CLQ_OK);
        EXPECT_NEAR(arm.shown(10)[0].clip_time_s, static_cast<double>(phase_s), 1e-6);
    }
}

TEST(Play, AMaskedLayerMovesTheNodesBelowItsNodeAndEndsAfterItsLoops)
{
    Arm arm;
    clq_layer_def def = clq_layer_def_init();
    def.play.clip = Arm::bent, def.play.start_s = 5;
    def.loops = 2, def.fade_in_s = 0.2f, def.fade_out_s = 0.4f;
    def.mask = arm.add_mask("elbow", 1);
    ASSERT_EQ(clq_actor_add_layer(arm.crowd, arm.actor, &def, nullptr), CLQ_OK) << clq_last_error();
    for (const double t : {4.9, 5.1, 6.0, 6.8, 7.0, 9.0}) {
        const double weight = t < 5 || t >= 7 ? 0 : smooth((t - 5) / 0.2) * smooth((7 - t) / 0.4);
        EXPECT_NEAR(arm.angle(0, t), in(Arm::slow, 0, t), close) << "not in the mask";
        EXPECT_NEAR(arm.angle(1, t), mixed(in(Arm::slow, 1, t), in(Arm::bent, 1, 0), 0.5 * weight), close) << "feather";
        EXPECT_NEAR(arm.angle(2, t), mixed(in(Arm::slow, 2, t), in(Arm::bent, 2, 0), weight), close);
    }
}

TEST(Play, AnAddedLayerTurnsOnTopAndGoesWhenItIsEnded)
{
    Arm arm;
    clq_layer_def def = clq_layer_def_init();
    def.kind = CLQ_LAYER_ADD, def.play.clip = Arm::wave, def.play.start_s = 5;
    clq_layer layer;
    ASSERT_EQ(clq_actor_add_layer(arm.crowd, arm.actor, &def, &layer), CLQ_OK) << clq_last_error();
    for (const double t : {5.05, 5.1, 7.3}) {
        EXPECT_NEAR(arm.angle(2, t), in(Arm::slow, 2, t) + in(Arm::wave, 2, t - 5), close);
        EXPECT_NEAR(arm.angle(1, t), in(Arm::slow, 1, t), close);
    }
    ASSERT_EQ(clq_actor_end_layer(arm.crowd, arm.actor, layer, 8, 0.5f), CLQ_OK);
    EXPECT_EQ(arm.shown(8.2).size(), 2u);
    EXPECT_EQ(arm.shown(8.5).size(), 1u);
    layer.index1 += 7;
    EXPECT_EQ(clq_actor_end_layer(arm.crowd, arm.actor, layer, 8, 0.5f), CLQ_STALE_ID);
}

TEST(Play, FinishedFadesMakeRoomAndOneWithoutRoomIsRefused)
{
    Arm arm;
    for (int i = 0; i < 3; ++i) arm.fade(Arm::fast + i, 10 + i, 5);
    const clq_fade_def to = arm.motion(Arm::slow, 13);
    EXPECT_EQ(api_test::fade_to(arm.crowd, arm.actor, to, 14, 1, CLQ_CURVE_SMOOTH), CLQ_LIMIT);
    EXPECT_NE(std::string(clq_last_error()).find("at most 3 fades"), std::string::npos) << clq_last_error();
    EXPECT_EQ(api_test::fade_to(arm.crowd, arm.actor, to, 15, 1, CLQ_CURVE_SMOOTH), CLQ_OK) << clq_last_error();
    // For an earlier time: fades that would begin later are replaced.
    EXPECT_EQ(api_test::fade_to(arm.crowd, arm.actor, to, 11, 1, CLQ_CURVE_SMOOTH), CLQ_OK) << clq_last_error();
    EXPECT_EQ(arm.shown(11.5).size(), 2u);
    EXPECT_EQ(arm.shown(12.5).size(), 1u) << "those from 12 and 15 on are gone";
    clq_layer_def def = clq_layer_def_init();
    def.play.clip = Arm::wave, def.play.start_s = 20;
    for (int i = 0; i < 4; ++i) EXPECT_EQ(clq_actor_add_layer(arm.crowd, arm.actor, &def, nullptr), CLQ_OK);
    EXPECT_EQ(clq_actor_add_layer(arm.crowd, arm.actor, &def, nullptr), CLQ_LIMIT);
}

TEST(Play, AnyTimeShowsTheSameWhateverIsKept)
{
    std::vector<uint64_t> hashes[3];
    for (int mode = 0; mode < 3; ++mode) {
        clq_crowd_def def = clq_crowd_def_init();
        def.cache = mode == 2 ? CLQ_CACHE_NONE : CLQ_CACHE_FULL;
        if (mode == 1) def.cache_budget_bytes = 1;
        Arm arm(&def);
        clq_fade_def motion = arm.motion(0, 1);
        motion.gait = arm.add_gait(Arm::slow, Arm::fast);
        motion.share = 0.4f;
        ASSERT_EQ(api_test::fade_to(arm.crowd, arm.actor, motion, 1, 0.5f, CLQ_CURVE_SMOOTH), CLQ_OK);
        arm.fade(Arm::bent, 2, 0.5f);
        clq_layer_def layer = clq_layer_def_init();
        layer.kind = CLQ_LAYER_ADD, layer.play.clip = Arm::wave, layer.play.start_s = 1.5, layer.loops = 2;
        layer.mask = arm.add_mask("hand");
        ASSERT_EQ(clq_actor_add_layer(arm.crowd, arm.actor, &layer, nullptr), CLQ_OK);
        clq_view *view;
        ASSERT_EQ(clq_view_create(arm.crowd, &view), CLQ_OK);
        clq_camera camera;
        const double eye[3] = {0, 1, 12}, target[3] = {0, 1, 0};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 1, 1, 0.1f, 100), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view, &camera), CLQ_OK);
        hashes[mode].resize(60);
        for (int i = 0; i < 60; ++i) {
            const int frame = mode == 0 ? i : (i * 37) % 60;
            ASSERT_EQ(clq_crowd_update(arm.crowd, 0.05 * frame, &view, 1), CLQ_OK);
            hashes[mode][frame] = clq_view_get_hash(view);
            double shown[16], again[16];
            clq_actor_info info = clq_actor_info_init();
            ASSERT_EQ(clq_actor_get_info(arm.crowd, arm.actor, &info), CLQ_OK);
            ASSERT_EQ(clq_actor_get_node(arm.crowd, arm.actor, 2, NAN, shown), CLQ_OK);
            ASSERT_EQ(clq_actor_get_node(arm.crowd, arm.actor, 2, info.tick_s, again), CLQ_OK);
            for (int k = 0; k < 16; ++k) EXPECT_EQ(shown[k], again[k]) << "at its cached age or exactly";
        }
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
    EXPECT_NE(hashes[0][24], hashes[0][25]);
}

TEST(Play, RandomPlaysFollowTheirWeightsAndRepeat)
{
    Arm arm;
    clq_random_play_def def = clq_random_play_def_init();
    const uint32_t clips[3] = {Arm::slow, Arm::fast, Arm::bent};
    const float weights[3] = {1, 0, 3};
    def.clip_count = 3, def.clips = clips, def.weights = weights;
    def.speed_spread = 0.2f, def.phase_spread = 1;
    int drawn[Arm::clip_count] = {};
    double least = 9, most = 0;
    for (uint32_t i = 0; i < 4000; ++i) {
        clq_play play, again;
        ASSERT_EQ(api_test::sample_play(arm.crowd, arm.actor, def, i, 3, &play), CLQ_OK) << clq_last_error();
        ASSERT_EQ(api_test::sample_play(arm.crowd, arm.actor, def, i, 3, &again), CLQ_OK);
        EXPECT_EQ(play.speed, again.speed);
        ++drawn[play.clip];
        least = std::min(least, double(play.speed)), most = std::max(most, double(play.speed));
        EXPECT_LT(play.phase_s, Arm::length_s[play.clip]);
    }
    EXPECT_EQ(drawn[Arm::fast], 0);
    EXPECT_NEAR(drawn[Arm::bent], 3000, 120);
    EXPECT_NEAR(least, 0.8, 0.01);
    EXPECT_NEAR(most, 1.2, 0.01);
}

}  // namespace
