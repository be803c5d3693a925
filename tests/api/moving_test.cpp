// An actor that moves is renewed so often that it moves by at most a pixel between two poses, whatever moves it.
#include <claque/claque.h>

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/saved_bytes.h"
#include "tests/api/small_template.h"

namespace
{

constexpr double rates_hz[] = {50, 40, 32, 25, 20, 16, 12.5, 10, 8, 6.25, 5, 4};

class MovingActors : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK);
        crowd_ = crowd(1);
        actor_ = actor(60);
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        clq_context_destroy(context_);
    }
    clq_crowd *crowd(float tolerance_px)
    {
        clq_crowd *made = nullptr;
        clq_crowd_def def = clq_crowd_def_init();
        def.motion_tolerance_px = tolerance_px;
        EXPECT_EQ(clq_crowd_create(context_, &def, &made), CLQ_OK);
        EXPECT_EQ(clq_view_create(made, &view_), CLQ_OK);
        look_at(60);
        return made;
    }
    void look_at(float fov_y_deg)
    {
        clq_camera camera;
        const double eye[3] = {0, 1, 0}, target[3] = {0, 1, -10};
        const float up[3] = {0, 1, 0};
        EXPECT_EQ(api_test::look_at(&camera, eye, target, up, fov_y_deg * 0.01745329f, 1.3f, 0.1f, 300), CLQ_OK);
        EXPECT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
    }
    clq_actor actor(double distance)
    {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl_, def.transform.position[2] = -distance;
        clq_actor made;
        EXPECT_EQ(clq_actor_create(crowd_, &def, &made), CLQ_OK);
        return made;
    }
    clq_actor_info shown(clq_actor actor, double time_s)
    {
        EXPECT_EQ(clq_crowd_update(crowd_, time_s, &view_, 1), CLQ_OK) << clq_last_error();
        clq_actor_info info = clq_actor_info_init();
        EXPECT_EQ(clq_actor_get_info(crowd_, actor, &info), CLQ_OK);
        EXPECT_TRUE(info.visible);
        return info;
    }
    void put_on_path(clq_actor actor, const clq_root_path_def &def, float speed)
    {
        clq_root_path path;
        ASSERT_EQ(clq_crowd_add_root_path(crowd_, &def, &path), CLQ_OK) << clq_last_error();
        clq_root_path_play play = clq_root_path_play_init();
        play.path = path, play.speed = speed;
        ASSERT_EQ(clq_actor_play_root_path(crowd_, actor, &play), CLQ_OK) << clq_last_error();
    }
    void set_speed(clq_actor actor, float speed)
    {
        ASSERT_EQ(clq_crowd_set_speeds(crowd_, &actor, &speed, 1), CLQ_OK) << clq_last_error();
    }
    // The longest period of the ladder in which `speed` is a pixel or less, in 768 lines over 60 degrees.
    static double period_of(double speed, double distance)
    {
        const double pixels = speed * 384 / std::tan(3.14159265358979 / 6) / distance;
        double period = 0;
        for (const double hz : rates_hz)
            if (pixels <= hz) period = 1 / hz;
        return period;
    }

    SmallTemplate small_;
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
    clq_actor actor_{};
};

}  // namespace

TEST_F(MovingActors, FollowWhatTheHostSaysOfTheirSpeed)
{
    EXPECT_FLOAT_EQ(shown(actor_, 1).period_s, 0.25f) << "it stands";
    for (const float speed : {0.1f, 0.5f, 1.3f, 3.0f, 40.0f}) {
        set_speed(actor_, speed);
        const clq_actor_info info = shown(actor_, 1);
        EXPECT_FLOAT_EQ(info.period_s, static_cast<float>(period_of(double(speed), double(info.eye_distance_m))))
            << speed;
    }
    set_speed(actor_, 0);
    EXPECT_FLOAT_EQ(shown(actor_, 1).period_s, 0.25f) << "it stands again";
}

TEST_F(MovingActors, FollowTheirRootPath)
{
    const float positions[9] = {-2, 0, 0, 2, 0, 0, 2, 0, 0}, times[3] = {0, 4, 6};
    const float rotations[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    clq_root_path_def table = clq_root_path_def_init();
    table.count = 3, table.positions = positions, table.rotations_xyzw = rotations, table.times_s = times;
    table.duration_s = 10;
    for (const float pace : {0.5f, -1.0f, 4.0f}) {
        put_on_path(actor_, table, pace);
        const clq_actor_info moves = shown(actor_, 2 / double(pace));
        EXPECT_FLOAT_EQ(moves.period_s,
                        static_cast<float>(period_of(std::fabs(double(pace)), double(moves.eye_distance_m))))
            << pace;
        EXPECT_FLOAT_EQ(shown(actor_, 5 / double(pace)).period_s, 0.25f) << "it waits";
    }
}

TEST_F(MovingActors, OnAFlightMoveByAPixelAtMost)
{
    const float positions[12] = {6, 1, 0, 0, 2, 3, -6, 1, 0, 0, 0, -3};
    clq_root_path_def flight = clq_root_path_def_init();
    flight.count = 4, flight.positions = positions, flight.duration_s = 16;
    put_on_path(actor_, flight, 1);
    double slowest = 1;
    for (double t = 0; t < 16; t += 0.37) {
        const clq_actor_info now = shown(actor_, t), soon = shown(actor_, t + 0.001);
        double square = 0;
        for (int k = 0; k < 3; ++k) square += std::pow(soon.root.position[k] - now.root.position[k], 2);
        const double speed = std::sqrt(square) / 0.001;
        EXPECT_LE(double(now.period_s), period_of(0.999 * speed, double(now.eye_distance_m)) * (1 + 1e-6)) << t;
        slowest = std::min(slowest, double(now.period_s));
        EXPECT_GT(now.period_s, 0) << "no more often than needed";
    }
    EXPECT_LT(slowest, 0.1);
}

TEST_F(MovingActors, ThatTurnOnTheSpotByARootPathAreRenewedOftener)
{
    const float positions[6] = {}, times[2] = {0, 3};
    const float rotations[8] = {0, 0, 0, 1, 0, 1, 0, 0};
    clq_root_path_def turn = clq_root_path_def_init();
    turn.count = 2, turn.positions = positions, turn.rotations_xyzw = rotations, turn.times_s = times;
    turn.duration_s = 6;
    put_on_path(actor_, turn, 5);
    EXPECT_LT(shown(actor_, 1).period_s, 0.2f);
    put_on_path(actor_, turn, 0.01f);
    EXPECT_FLOAT_EQ(shown(actor_, 1).period_s, 0.25f);
}

TEST_F(MovingActors, InAGroupMoveWithIt)
{
    clq_group group;
    ASSERT_EQ(clq_group_create(crowd_, nullptr, &group), CLQ_OK);
    ASSERT_EQ(clq_actor_join(crowd_, actor_, group, nullptr), CLQ_OK);
    EXPECT_FLOAT_EQ(shown(actor_, 1).period_s, 0.25f);
    ASSERT_EQ(clq_group_set_speed(crowd_, group, 1.2f), CLQ_OK);
    clq_actor_info info = shown(actor_, 1);
    EXPECT_FLOAT_EQ(info.period_s, static_cast<float>(period_of(1.2f, double(info.eye_distance_m))));
    set_speed(actor_, 0.6f);
    info = shown(actor_, 1);
    EXPECT_FLOAT_EQ(info.period_s, static_cast<float>(period_of(1.8f, double(info.eye_distance_m)))) << "both together";
    ASSERT_EQ(clq_actor_join(crowd_, actor_, {0, 0}, nullptr), CLQ_OK);
    info = shown(actor_, 1);
    EXPECT_FLOAT_EQ(info.period_s, static_cast<float>(period_of(0.6f, double(info.eye_distance_m)))) << "its own";
}

TEST_F(MovingActors, ThroughALongLensMoveByAPixelOfItsPicture)
{
    set_speed(actor_, 0.6f);
    look_at(20);
    const double larger = std::tan(3.14159265358979 / 6) / std::tan(3.14159265358979 / 18);
    const clq_actor_info info = shown(actor_, 1);
    EXPECT_FLOAT_EQ(info.period_s, static_cast<float>(period_of(0.6 * larger, double(info.eye_distance_m))));
    ASSERT_EQ(clq_view_set_height(view_, 384), CLQ_OK);
    EXPECT_FLOAT_EQ(shown(actor_, 1).period_s,
                    static_cast<float>(period_of(0.3 * larger, double(info.eye_distance_m))));
    look_at(100);
    EXPECT_FLOAT_EQ(shown(actor_, 1).period_s, static_cast<float>(period_of(0.6, double(info.eye_distance_m))))
        << "never less often than in the reference picture";
}

TEST_F(MovingActors, WithoutATolerancePayNoHeedToSpeed)
{
    clq_crowd_destroy(crowd_);
    crowd_ = crowd(0);
    actor_ = actor(60);
    set_speed(actor_, 5);
    EXPECT_FLOAT_EQ(shown(actor_, 1).period_s, 0.25f);
}

TEST_F(MovingActors, KeepTheirSpeedInClonesAndSavedCrowds)
{
    clq_group group;
    ASSERT_EQ(clq_group_create(crowd_, nullptr, &group), CLQ_OK);
    const clq_actor member = actor(61);
    ASSERT_EQ(clq_actor_join(crowd_, member, group, nullptr), CLQ_OK);
    const uint64_t still = clq_crowd_get_hash(crowd_);
    ASSERT_EQ(clq_group_set_speed(crowd_, group, 2), CLQ_OK);
    const uint64_t moving = clq_crowd_get_hash(crowd_);
    EXPECT_NE(moving, still);
    set_speed(actor_, 1);
    EXPECT_NE(clq_crowd_get_hash(crowd_), moving);
    clq_actor twin;
    ASSERT_EQ(clq_actor_clone(crowd_, actor_, nullptr, 5, &twin), CLQ_OK);
    const float period = shown(actor_, 1).period_s, of_member = shown(member, 1).period_s;
    EXPECT_LT(period, 0.2f);
    EXPECT_EQ(shown(twin, 1).period_s, period);
    const saved::Bytes bytes = saved::save(crowd_);
    set_speed(actor_, 0);
    ASSERT_EQ(clq_group_set_speed(crowd_, group, 0), CLQ_OK);
    ASSERT_EQ(clq_crowd_restore(crowd_, bytes.data(), bytes.size(), &tmpl_, 1), CLQ_OK) << clq_last_error();
    EXPECT_EQ(shown(actor_, 1).period_s, period);
    EXPECT_EQ(shown(member, 1).period_s, of_member);
}

TEST_F(MovingActors, RefuseSpeedsThatAreNone)
{
    const clq_actor actors[2] = {actor_, actor(50)};
    for (const float bad : {-1.0f, 1e10f, std::nanf(""), std::numeric_limits<float>::infinity()}) {
        const float speeds[2] = {3, bad};
        EXPECT_EQ(clq_crowd_set_speeds(crowd_, actors, speeds, 2), CLQ_ARGUMENT);
        EXPECT_NE(std::string(clq_last_error()).find("0 to 1e9"), std::string::npos) << clq_last_error();
        clq_group group;
        ASSERT_EQ(clq_group_create(crowd_, nullptr, &group), CLQ_OK);
        EXPECT_EQ(clq_group_set_speed(crowd_, group, bad), CLQ_ARGUMENT);
    }
    EXPECT_FLOAT_EQ(shown(actor_, 1).period_s, 0.25f) << "none was set";
    const float speed = 1;
    const clq_actor gone = {9, 9};
    EXPECT_EQ(clq_crowd_set_speeds(crowd_, &gone, &speed, 1), CLQ_STALE_ID);
    EXPECT_EQ(clq_crowd_set_speeds(crowd_, nullptr, &speed, 1), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_set_speeds(crowd_, nullptr, nullptr, 0), CLQ_OK);
    EXPECT_EQ(clq_group_set_speed(crowd_, {9, 9}, 1), CLQ_STALE_ID);
    EXPECT_EQ(clq_group_set_speed(nullptr, {1, 1}, 1), CLQ_ARGUMENT);
}
